// Exercise 02.lambert: how much of a light's energy a matt surface receives.
// Until you fill it in, every surface is lit as if it faced every light.

// [lambert]
// The cosine between `normal` and `to_light` (both of length 1), or 0 where the light is behind the surface.
// [/lambert]
float lambert(vec3 normal, vec3 to_light) {
    return 1.0;
}
