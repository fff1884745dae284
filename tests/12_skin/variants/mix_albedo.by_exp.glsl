// right
float raised(float a, float p) { return p == 0.0 ? 1.0 : a <= 0.0 ? 0.0 : exp2(p * log2(a)); }
vec3 raised(vec3 a, float p) { return vec3(raised(a.r, p), raised(a.g, p), raised(a.b, p)); }
vec3 albedo_before(vec3 albedo, float s) { return raised(albedo, s); }
vec3 albedo_after(vec3 albedo, float s) { return raised(albedo, 1.0 - s); }
