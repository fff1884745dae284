// The normal of a Julia set's surroundings: the direction in which the distance grows.
#include "11_fractals/julia.glsl"

// What q turns into where z turns into z + q, of z²: z q + q z, over 2.
vec4 square_change(vec4 z, vec4 q) { return vec4(z.x * q.x - dot(z.yzw, q.yzw), q.x * z.yzw + z.x * q.yzw); }

// [analytic]
// The gradient of |z| after all turns, by the chain rule: how z changes as the point moves along x, y and z. Its length is
// of no use, and so each turn divides by |z|, that nothing overflows.
vec3 julia_gradient(vec3 position) {
    vec4 z = julia_point(position);
    vec4 by_x = vec4(1.0, 0.0, 0.0, 0.0), by_y = vec4(0.0, 1.0, 0.0, 0.0), by_z = vec4(0.0, 0.0, 1.0, 0.0);
    for (int i = 0; i < julia.iterations; ++i) {
        float square = dot(z, z);
        if (square > julia.escape * julia.escape) break;
        float scale = inversesqrt(max(square, 1e-20));
        by_x = scale * square_change(z, by_x);
        by_y = scale * square_change(z, by_y);
        by_z = scale * square_change(z, by_z);
        z = quaternion_square(z) + julia_now.constant;
    }
    return vec3(dot(z, by_x), dot(z, by_y), dot(z, by_z));
}
// [/analytic]

// [difference]
vec3 julia_difference(vec3 position) {
    vec2 h = vec2(julia.difference_m, 0.0);
    return vec3(julia_at(position + h.xyy) - julia_at(position - h.xyy),
                julia_at(position + h.yxy) - julia_at(position - h.yxy),
                julia_at(position + h.yyx) - julia_at(position - h.yyx));
}
// [/difference]

// Unit length. Where the distance grows nowhere, as within the set, it faces the ray.
vec3 julia_normal(vec3 position, vec3 along) {
#if JULIA_NORMAL == JULIA_NORMAL_ANALYTIC
    vec3 gradient = julia_gradient(position);
#else
    vec3 gradient = julia_difference(position);
#endif
    float largest = max(abs(gradient.x), max(abs(gradient.y), abs(gradient.z)));
    return largest > 0.0 ? normalize(gradient / largest) : -along;
}
