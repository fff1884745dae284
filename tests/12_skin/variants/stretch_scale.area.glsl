// wrong: stretch_scale(
vec2 stretch_scale(vec3 du_mm, vec3 dv_mm, float most_texels) { return vec2(min(inversesqrt(max(length(cross(du_mm, dv_mm)), 1e-12)), most_texels)); }
