// Solution of 08.soft_knee.
float soft_knee(float luminance, float threshold, float knee) {
    float w = knee * threshold;
    float above = luminance - threshold;
    if (above >= w) return above;
    if (above <= -w) return 0.0;
    return (above + w) * (above + w) / (4.0 * w);
}
