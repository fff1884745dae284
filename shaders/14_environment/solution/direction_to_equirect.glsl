// Solution of 14.direction_to_equirect.
vec2 direction_to_equirect(vec3 direction) {
    const float pi = 3.14159265358979;
    float across = length(direction.xz);
    float u = across > 0.0 ? 0.5 + atan(direction.x, -direction.z) / (2.0 * pi) : 0.5;
    // Near the poles acos(y) loses digits that atan keeps.
    return vec2(u, atan(across, direction.y) / pi);
}
