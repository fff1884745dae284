// Exercise 12.kelemen_szirmay_kalos: the light that a rough surface reflects towards the camera.
// Starter: nothing shines.
#include "12_skin/skin.glsl"

// [kelemen_szirmay_kalos]
// Returns f times n.l, in 1/sr, for the reflectance model of C. Kelemen and L.
// Szirmay-Kalos (2001): f = D F / |l + v|^2. n (normal), l (to the light) and v (to the
// camera) have unit length. Available are D = beckmann_of(cosine, m), the distribution
// of facets, and F = fresnel_of(cosine, f0), the reflectance of one facet. Each takes
// the cosine of an angle with the half vector h, which is l + v at unit length. Decide
// which: D asks how far the facet is tilted from the surface, F at what angle the light
// meets the facet. |l + v|^2 is that of the sum before it is normalised.
//
// The result is 0 if the light or the camera is below the horizon (n.l <= 0 or
// n.v <= 0), and never negative. If l and v are opposite, there is no half vector; then
// one of them is below the horizon, so test that first.
// [/kelemen_szirmay_kalos]
float kelemen_szirmay_kalos(vec3 n, vec3 l, vec3 v, float m, float f0) { return 0.0; }
