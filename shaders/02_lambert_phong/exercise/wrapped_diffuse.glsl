// Exercise 02.wrapped_diffuse: light that reaches around the edge, as on skin, wax and cloud tops.
// Until you fill it in, a surface is lit evenly.

// [wrapped_diffuse]
// ((cosine + wrap) / (1 + wrap)) to the power of `power`, and 0 where that would be negative. `cosine` is between the
// normal and the direction to the light, from -1 to 1; wrap is 0 (Lambert) to 1 (lit all around); power is above 0.
// [/wrapped_diffuse]
float wrapped_diffuse(float cosine, float wrap, float power) {
    return 0.5;
}

// [wrapped_tint]
// The colour of that light: `tint` where the cosine is 0 or less, white where it is 1, in proportion in between.
// [/wrapped_tint]
vec3 wrapped_tint(float cosine, vec3 tint) {
    return vec3(1.0);
}
