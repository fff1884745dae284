// Solution of 14.choose_estimator.
ivec2 choose_estimator(int surface) {
    if (surface == 0) return ivec2(2, 16);
    if (surface == 1) return ivec2(3, 4);
    return ivec2(4, 16);
}
