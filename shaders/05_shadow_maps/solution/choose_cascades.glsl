// Solution of 05.choose_cascades.
ivec3 choose_cascades(int scene) {
    if (scene == 0) return ivec3(4, 1024, 100);
    if (scene == 1) return ivec3(4, 1024, 75);
    return ivec3(2, 1024, 100);
}
