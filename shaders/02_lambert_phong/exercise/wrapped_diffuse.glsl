// Exercise 02.wrapped_diffuse: diffuse light that reaches beyond the terminator, as on skin, wax and cloud tops.
// Starter: a surface is lit evenly.

// [wrapped_diffuse]
// Wrapped diffuse light: ((cosine + wrap) / (1 + wrap)) raised to `power`, and 0 where the
// base of this power would be negative, since GLSL leaves pow of a negative number
// undefined. `cosine` is the cosine of the angle between the normal and the direction to
// the light, from -1 to 1. `wrap` runs from 0 (Lambert) to 1 (lit all around); `power` is
// above 0.
// [/wrapped_diffuse]
float wrapped_diffuse(float cosine, float wrap, float power) {
    return 0.5;
}

// [wrapped_tint]
// The colour of wrapped light: `tint` where the cosine is 0 or less, white where it is 1,
// and linear in the cosine in between.
// [/wrapped_tint]
vec3 wrapped_tint(float cosine, vec3 tint) {
    return vec3(1.0);
}
