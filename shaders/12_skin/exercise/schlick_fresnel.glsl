// Exercise 12.schlick_fresnel: how much light a smooth surface reflects, by the angle.
// Until you fill it in, that is the same from every side.

// [schlick_fresnel]
// C. Schlick, "An Inexpensive BRDF Model for Physically-based Rendering", 1994: the share of light that is reflected,
// f0 for cosine = 1 and all of it for cosine = 0; in between it falls with the fifth power of 1 - cosine. `cosine` is of
// the angle between the view and the half vector, not the normal; rounding may bring it a little below 0 or above 1, and
// the result must stay from f0 to 1. f0 is 0 to 1 (skin: 0.028).
// [/schlick_fresnel]
float schlick_fresnel(float cosine, float f0) { return f0; }
