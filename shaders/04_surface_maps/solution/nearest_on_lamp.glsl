// Solution of 04.nearest_on_lamp.
vec3 nearest_on_lamp(vec3 middle, float radius, vec3 mirrored) {
    vec3 to_ray = max(dot(middle, mirrored), 0.0) * mirrored - middle;
    return middle + to_ray * min(radius / max(length(to_ray), 1e-12), 1.0);
}
