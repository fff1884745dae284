// wrong: albedo
vec3 albedo_before(vec3 albedo, float s) { return pow(albedo, vec3(s)); }
vec3 albedo_after(vec3 albedo, float s) { return pow(albedo, vec3(1.0 - s)); }
