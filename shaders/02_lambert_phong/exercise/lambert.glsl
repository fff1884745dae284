// Exercise 02.lambert: the light that a matt surface receives, relative to a surface that faces the light.
// Starter: every surface is lit as if it faced every light.

// [lambert]
// The cosine of the angle between the unit vectors `normal` and `to_light`, or 0 if the
// light is behind the surface.
// [/lambert]
float lambert(vec3 normal, vec3 to_light) {
    return 1.0;
}
