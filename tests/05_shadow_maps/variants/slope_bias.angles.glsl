// right
float slope_bias(float cosine, float texel, float reach) {
    return length(vec2(reach * texel)) * tan(acos(clamp(cosine, 0.025, 1.0)));
}
