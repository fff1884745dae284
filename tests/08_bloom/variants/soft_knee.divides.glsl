// wrong: divides
float soft_knee(float luminance, float threshold, float knee) {
    float w = knee * threshold;
    float s = clamp(luminance - threshold + w, 0.0, 2.0 * w);
    return max(s * s / (4.0 * w), luminance - threshold);
}
