// A quaternion Julia set in a slice through four dimensions: distances along rays, normals, and shading. The module
// Julia provides all names used here.
#include "11_fractals/julia_data.h"
#include "11_fractals/julia_distance.glsl"
#include "11_fractals/march.glsl"

layout(scalar) uniform JuliaBlock {
    float slice, escape, step_m, epsilon_m, relaxation, footprint, trust, difference_m;
    int iterations, most_steps;
} julia;
layout(scalar) uniform JuliaNowBlock { JuliaNow julia_now; };

// The fp64 truth's own settings are finer (truth.h); this is the limit of a float.
const float exact_epsilon = 2e-5, exact_share = 0.3;

vec4 julia_point(vec3 position) { return vec4(position, julia.slice); }

float julia_at(vec3 position) {
    return julia_distance(julia_point(position), julia_now.constant, julia.iterations, julia.escape);
}

float distance_at(float t) { return julia.trust * julia_at(march_from + t * march_along); }

vec3 pixel_direction(ivec2 pixel) {
    return normalize(ray_through(julia_now.rays, vec2(pixel) + 0.5));
}

// Where the ray is within the ball that holds the set; an end before its start: nowhere.
vec2 within_bound(vec3 from, vec3 along) {
    float middle = -dot(from, along);
    vec3 beside = from + middle * along;  // not |from|² - middle²: from afar those cancel
    float bound = julia_now.bound, half_square = bound * bound - dot(beside, beside);
    if (half_square <= 0.0) return vec2(0.0, -1.0);
    float half_chord = sqrt(half_square);
    return vec2(max(middle - half_chord, 0.0), middle + half_chord);
}

// Steps of one length, each with the question whether the set is nearer than half of it.
March march_fixed(float start, float end) {
    int steps = 0;
    for (float t = start; t < end; t += julia.step_m)
        if (distance_at(t) < 0.5 * julia.step_m || ++steps >= 4096) return March(t, steps + 1, MARCH_HIT);
    return March(end, steps, MARCH_MISS);
}

// By the method in use, from `start` on.
March march_julia(float start, float end) {
#if JULIA_METHOD == JULIA_METHOD_FIXED
    return march_fixed(start, end);
#elif JULIA_METHOD == JULIA_METHOD_DISTANCE
    return march(start, end, julia.epsilon_m, 0.0, 1.0, julia.most_steps);
#elif JULIA_METHOD == JULIA_METHOD_RELAXED
    return march(start, end, julia.epsilon_m, 0.0, julia.relaxation, julia.most_steps);
#elif JULIA_METHOD == JULIA_METHOD_CONE
    return march(start, end, 0.0, julia.footprint * julia_now.pixel_rad, 1.0, julia.most_steps);
#else
    int steps = 0;
    for (float t = start; t < end; ++steps) {
        float distance = distance_at(t);
        if (distance < exact_epsilon || steps >= 4096) return March(t, steps + 1, MARCH_HIT);
        t += exact_share * distance;
    }
    return March(end, steps, MARCH_MISS);
#endif
}
