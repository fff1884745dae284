// right
float soft_knee(float luminance, float threshold, float knee) {
    float w = knee * threshold;
    float s = clamp(luminance - threshold + w, 0.0, 2.0 * w);
    return max(s * s / max(4.0 * w, 1e-12), max(luminance - threshold, 0.0));
}
