// Exercise 12.beckmann: the distribution of the facets' normals on a rough surface.
// Starter: all directions have the same number of facets.

// [beckmann]
// Returns the distribution D of facet normals (P. Beckmann and A. Spizzichino, 1963) at
// the angle a from the surface normal, where cos a = n_dot_h (-1 to 1). m is the root
// mean square slope of the facets, 0.005 to 1. D is proportional to
//
//     exp(-tan^2 a / m^2) / cos^4 a
//
// with a factor that depends only on m, such that the integral of D * n_dot_h over the
// hemisphere is 1. With t = tan a that integral is the integral of exp(-t^2 / m^2) 2 pi
// t dt times the factor. (One paper leaves out a part of the factor, and its skin
// shines three times too brightly.)
//
// No facet faces below the horizon: 0 for n_dot_h <= 0. Near 0, tan^2 a overflows and
// cos^4 a becomes 0. A division by 0 is undefined in GLSL; the result there is 0, must
// be found without such a division, and is never NaN. n_dot_h may be slightly above 1
// by rounding.
// [/beckmann]
float beckmann(float n_dot_h, float m) { return n_dot_h > 0.0 ? 0.31831 : 0.0; }
