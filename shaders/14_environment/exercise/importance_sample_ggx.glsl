// Exercise 14.importance_sample_ggx: normals of microfacets, as often as GGX says that they occur.
// Starter: every microfacet lies flat, and every reflection is a mirror's.

// [importance_sample_ggx]
// Returns the normal h of a microfacet, of unit length, in the space in which the surface's
// own normal n is (0, 0, 1). If the two numbers `random` are uniformly distributed from 0
// to 1 (1 excluded), the density of h over the solid angle is D(h) (n·h), where
//
//     D(h) = alpha² / (pi ((n·h)² (alpha² - 1) + 1)²)
//
// random.x chooses the angle around the normal: phi = 2 pi random.x, from x towards y.
// random.y chooses the angle theta from the normal, and theta grows with it: it is the
// angle at which the cumulative distribution, the integral of D(h) (n·h) from the normal up
// to theta, reaches random.y. With c = cos² theta this integral is
// (1 - c) / (1 + (alpha² - 1) c): solve for c. alpha is 0 to 1; at 0 all facets are (0, 0,
// 1). Never take the square root of a negative number, which is undefined in GLSL.
// [/importance_sample_ggx]
vec3 importance_sample_ggx(vec2 random, float alpha) {
    return vec3(0.0, 0.0, 1.0);
}
