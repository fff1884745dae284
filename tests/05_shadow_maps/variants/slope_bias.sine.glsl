// wrong: slope_bias
float slope_bias(float cosine, float texel, float reach) {
    return sqrt(2.0) * reach * texel * sqrt(max(1.0 - cosine * cosine, 0.0));
}
