// Solution of 05.slope_bias.

float slope_bias(float cosine, float texel, float reach) {
    float c = clamp(cosine, 0.025, 1.0);
    float tangent = sqrt(1.0 - c * c) / c;
    return sqrt(2.0) * reach * texel * tangent;  // the plane may fall along the texel's diagonal
}
