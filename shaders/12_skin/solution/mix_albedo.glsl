// Solution of 12.mix_albedo.

vec3 albedo_power(vec3 albedo, float power) {
    return power <= 0.0 ? vec3(1.0) : pow(max(albedo, 0.0), vec3(power));
}

vec3 albedo_before(vec3 albedo, float s) { return albedo_power(albedo, s); }

vec3 albedo_after(vec3 albedo, float s) { return albedo_power(albedo, 1.0 - s); }
