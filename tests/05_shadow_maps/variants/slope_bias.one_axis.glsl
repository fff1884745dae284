// wrong: slope_bias
float slope_bias(float cosine, float texel, float reach) {
    float c = max(cosine, 0.025);
    return reach * texel * sqrt(max(1.0 - c * c, 0.0)) / c;
}
