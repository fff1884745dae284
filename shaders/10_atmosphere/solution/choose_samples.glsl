// Solution of 10.choose_samples.
ivec2 choose_samples(int path) {
    if (path == 0) return ivec2(3, 16);
    if (path == 1) return ivec2(1, 4);
    return ivec2(1, 1);
}
