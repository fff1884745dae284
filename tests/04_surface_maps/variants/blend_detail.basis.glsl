// right
vec3 blend_detail(vec3 base, vec3 detail) {
    // The rotation that takes z to the base, as a matrix.
    float s = 1.0 / (1.0 + base.z);
    vec3 x = vec3(1.0 - base.x * base.x * s, -base.x * base.y * s, -base.x);
    vec3 y = vec3(-base.x * base.y * s, 1.0 - base.y * base.y * s, -base.y);
    return normalize(detail.x * x + detail.y * y + detail.z * base);
}
