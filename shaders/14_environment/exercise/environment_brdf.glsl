// Exercise 14.environment_brdf: one sample of the two integrals A and B of the split sum.
// Starter: everything is reflected, whatever the metal: gold looks like silver.
#include "14_environment/importance_sample_ggx.glsl"
#include "14_environment/visible_half_vector.glsl"

// [environment_brdf]
// One sample of (A, B): the integrals over the half sphere of directions l of D V (1 - p) (n·l)
// and of D V p (n·l), with p = (1 - v·h)^5. The normal n is (0, 0, 1), v any direction with the
// cosine n_dot_v to it. n_dot_v and alpha are 0.001 to 1. `random` is a point of a set that
// covers the square 0 < x < 1, 0 <= y < 1 evenly. The mean over 1,024 such points must be within
// 0.004 of both integrals. Choose the half vector h by one of these two:
//
//     importance_sample_ggx(random, alpha)        density D (n·h)
//     visible_half_vector(random, v, alpha)       density D G1(v) (v·h) / (n·v)
//
// Both are densities over the solid angle of h. The solid angle of l, which is v mirrored at h,
// is 4 (v·h) times as large. A sample whose l lies below the surface counts, but reflects
// nothing. ggx_visibility(n·l, n·v, alpha) is V, ggx_density(n·h, alpha) is D, schlick_power(v·h)
// is p, and G1(v) = 2 (n·v) / (n·v + sqrt(alpha² + (1 - alpha²) (n·v)²)).
// [/environment_brdf]
vec2 environment_brdf(vec2 random, float n_dot_v, float alpha) {
    return vec2(0.0, 1.0);
}
