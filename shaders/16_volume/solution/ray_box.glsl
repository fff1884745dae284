// Solution of 16.ray_box: which of two planes comes first depends on the ray's direction.
vec2 ray_box(vec3 origin, vec3 direction, vec3 half_m) {
    vec3 safe = mix(direction, vec3(1e-12), lessThan(abs(direction), vec3(1e-12)));
    vec3 one = (-half_m - origin) / safe, other = (half_m - origin) / safe;
    vec3 near = min(one, other), far = max(one, other);
    return vec2(max(max(near.x, near.y), max(near.z, 0.0)), min(far.x, min(far.y, far.z)));
}
