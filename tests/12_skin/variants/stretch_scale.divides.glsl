// wrong: stretch_scale(
vec2 stretch_scale(vec3 du_mm, vec3 dv_mm, float most_texels) { return min(1.0 / vec2(length(du_mm), length(dv_mm)), vec2(most_texels)); }
