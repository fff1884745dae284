// wrong: albedo
vec3 albedo_before(vec3 albedo, float s) { return mix(vec3(1.0), albedo, s); }
vec3 albedo_after(vec3 albedo, float s) { return mix(albedo, vec3(1.0), s); }
