// Exercise 05.slope_bias: the bias that keeps a sloped surface from shadowing itself.
// Starter: there is none: stripes of shadow cover everything that does not face the light.

// [slope_bias]
// The largest distance, in metres, by which a plane can be nearer to the light at a texel
// that the filter reads than at the shaded point. A texel of the map is `texel` metres wide
// and holds one depth, that at its centre. A filter reads texels whose centres are up to
// `reach` texels away from the point, along u and along v at once; without a filter,
// `reach` is 0.5. `cosine` is the cosine of the angle between the plane's normal and the
// direction to the light, 0 to 1. At 0 the bias would be infinite: treat every cosine below
// 0.025 as 0.025.
// [/slope_bias]
float slope_bias(float cosine, float texel, float reach) {
    return 0.0;
}
