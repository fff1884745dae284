// Solution of 05.sphere_shadow.

// Depth of the line towards the light inside the sphere, in metres; negative if the line misses the sphere or the sphere
// lies behind the point.
float depth_in_sphere(vec3 to_center, float radius, vec3 to_light) {
    float along = dot(to_center, to_light);
    return along > 0.0 ? radius - length(to_center - along * to_light) : -1.0;
}

float sphere_shadow_hard(vec3 to_center, float radius, vec3 to_light) {
    return depth_in_sphere(to_center, radius, to_light) > 0.0 ? 0.0 : 1.0;
}

float sphere_shadow_power(vec3 to_center, float radius, vec3 to_light, float width, float power) {
    float depth = clamp(depth_in_sphere(to_center, radius, to_light) / width, 0.0, 1.0);
    return depth > 0.0 ? 1.0 - pow(depth, power) : 1.0;
}
