// right
float soft_knee(float luminance, float threshold, float knee) {
    float w = knee * threshold;
    float s = clamp(luminance - threshold + w, 0.0, 2.0 * w);
    float bent = w > 0.0 ? s * s / (4.0 * w) : 0.0;
    return max(bent, luminance - threshold);
}
