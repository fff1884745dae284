// right
float per_mm(float mm, float most) { return mm * most > 1.0 ? 1.0 / mm : most; }
vec2 stretch_scale(vec3 du_mm, vec3 dv_mm, float most_texels) {
    return vec2(per_mm(length(du_mm), most_texels), per_mm(length(dv_mm), most_texels));
}
