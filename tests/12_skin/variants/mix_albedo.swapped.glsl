// wrong: albedo
vec3 raised(vec3 a, float p) { return p <= 0.0 ? vec3(1.0) : pow(a, vec3(p)); }
vec3 albedo_before(vec3 albedo, float s) { return raised(albedo, 1.0 - s); }
vec3 albedo_after(vec3 albedo, float s) { return raised(albedo, s); }
