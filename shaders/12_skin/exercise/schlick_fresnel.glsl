// Exercise 12.schlick_fresnel: the reflectance of a smooth surface, by the angle.
// Starter: it is the same for all angles.

// [schlick_fresnel]
// Returns the reflected fraction of light by C. Schlick's approximation of Fresnel's
// equations (1994). It is f0 for a cosine of 1 and 1 for a cosine of 0. In between, the
// rise above f0 is proportional to the fifth power of 1 - cosine. f0 is 0 to 1 (skin:
// 0.028).
//
// `cosine` belongs to the angle between the view vector and the half vector, not the
// normal. Rounding may bring it slightly below 0 or above 1. The result must still be
// from f0 to 1, and pow of a negative number is undefined in GLSL.
// [/schlick_fresnel]
float schlick_fresnel(float cosine, float f0) { return f0; }
