// Exercise 12.kelemen_szirmay_kalos: the light that a rough surface reflects towards the eye.
// Until you fill it in, nothing shines.
#include "12_skin/skin.glsl"

// [kelemen_szirmay_kalos]
// C. Kelemen and L. Szirmay-Kalos, "A Microfacet Based Coupled Specular-Matte BRDF Model", Eurographics 2001 short papers:
// f = D(n·h) F(v·h) / |l + v|², times n·l. n, l (to the light) and v (to the eye) have unit length. D is beckmann_of(n·h, m),
// F is fresnel_of(v·h, f0), and h is l + v made unit length. Returns f times n·l, in 1/sr: 0 where the light or the eye is
// below the horizon, n·l <= 0 or n·v <= 0, and at least 0 everywhere. Opposite l and v have no half vector, and then one
// of them is below the horizon: ask for that first.
// [/kelemen_szirmay_kalos]
float kelemen_szirmay_kalos(vec3 n, vec3 l, vec3 v, float m, float f0) { return 0.0; }
