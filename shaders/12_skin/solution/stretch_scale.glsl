// Solution of 12.stretch_scale.

vec2 stretch_scale(vec3 du_mm, vec3 dv_mm, float most_texels) {
    // A texel that is narrower than the bound allows is taken for one that it does: no division by 0.
    return 1.0 / max(vec2(length(du_mm), length(dv_mm)), 1.0 / most_texels);
}
