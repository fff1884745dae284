// Solution of 04.choose_relief.
ivec2 choose_relief(int surface) {
    if (surface == 0) return ivec2(3, 1);
    if (surface == 1) return ivec2(4, 16);
    return ivec2(3, 15);
}
