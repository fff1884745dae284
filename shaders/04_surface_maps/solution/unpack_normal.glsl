// Solution of 04.unpack_normal.

vec3 unpack_normal(vec2 code, float strength) {
    vec2 xy = 2.0 * code - 1.0;
    vec3 normal = vec3(strength * xy, sqrt(max(0.0, 1.0 - dot(xy, xy))));
    // The length is 0 only if strength and z are both 0.
    return dot(normal, normal) > 0.0 ? normalize(normal) : vec3(0.0, 0.0, 1.0);
}
