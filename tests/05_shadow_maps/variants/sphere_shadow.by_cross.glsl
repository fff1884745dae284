// right
float sphere_shadow_hard(vec3 to_center, float radius, vec3 to_light) {
    vec3 side = cross(to_center, to_light);
    return dot(to_center, to_light) > 0.0 && dot(side, side) < radius * radius ? 0.0 : 1.0;
}

float sphere_shadow_power(vec3 to_center, float radius, vec3 to_light, float width, float power) {
    if (sphere_shadow_hard(to_center, radius, to_light) > 0.0) return 1.0;
    float depth = (radius - length(cross(to_center, to_light))) / width;
    return depth >= 1.0 || depth <= 0.0 ? float(depth <= 0.0) : 1.0 - exp2(power * log2(depth));
}
