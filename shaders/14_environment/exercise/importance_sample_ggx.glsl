// Exercise 14.importance_sample_ggx: normals of microfacets, as often as GGX says that they occur.
// Until you fill it in, every microfacet lies flat, and every reflection is a mirror's.

// [importance_sample_ggx]
// The normal of a microfacet, of unit length, in the space in which the surface's own normal is (0, 0, 1). With two
// numbers that are evenly distributed in 0 to 1 (1 excluded) its density over the solid angle is D(h) (n·h), where
//
//     D(h) = alpha² / (pi ((n·h)² (alpha² - 1) + 1)²)
//
// random.x chooses the angle around the normal: phi = 2 pi random.x, from x towards y. random.y chooses the angle from
// the normal, rising with it: invert the cumulative distribution, the integral of D(h) (n·h) from the normal up to the
// angle theta, which is random.y. (With c = cos² theta it is (1 - c) / (1 + (alpha² - 1) c).) alpha is 0 to 1; at 0 all
// facets are (0, 0, 1). Nothing may be taken of the root of a negative number.
// [/importance_sample_ggx]
vec3 importance_sample_ggx(vec2 random, float alpha) {
    return vec3(0.0, 0.0, 1.0);
}
