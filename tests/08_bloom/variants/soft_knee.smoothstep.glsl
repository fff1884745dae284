// wrong: soft_knee(luminance =
float soft_knee(float luminance, float threshold, float knee) {
    float w = max(knee * threshold, 1e-9);
    return luminance * smoothstep(threshold - w, threshold + w, luminance);
}
