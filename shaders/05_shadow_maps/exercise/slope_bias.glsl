// Exercise 05.slope_bias: by how much a surface has to be lifted so that it does not shadow itself.
// Until you fill it in, it is not lifted: stripes of shadow on everything that does not face the light.

// [slope_bias]
// A texel of the map holds one depth for all of its width, `texel` metres: that of its middle. A filter asks texels whose
// middle is up to `reach` texels away from the point, along u and along v at once: half a texel without any filter. How
// much nearer to the light, in metres, may a plane be there than at the point? `cosine` is that between its normal and
// the way to the light, 0 to 1. At a right angle to the light that has no end: take no cosine to be below 0.025.
// [/slope_bias]
float slope_bias(float cosine, float texel, float reach) {
    return 0.0;
}
