// wrong: soft_knee(luminance =
float soft_knee(float luminance, float threshold, float knee) {
    return max(luminance - threshold, 0.0);
}
