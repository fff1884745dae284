// Exercise 17.limb_fade: clouds at the edge of the planet.
// Starter: they are as opaque there as from above, and their shell's outline hangs over the ground's.

// [limb_fade]
// `opacity` (0 to 1) is what a layer of clouds hides when seen from straight above. At `mu`,
// the cosine of the angle between the layer's normal and the direction to the camera, the path
// through it is 1 / mu times as long: it lets through (1 - opacity)^(1 / mu). But at mu near 0
// the shell extends beyond the edge of the ground, and there a thin layer would look like a
// wall in empty space. So the result is (1 - (1 - opacity)^(1 / mu)) s²(3 - 2s), where s = mu /
// `width`, clamped to 0 to 1; `width` is above 0. At mu <= 0 the layer is seen from below,
// through the planet: return 0. An opacity of 0 gives 0 at any mu, and an opacity of 1 gives
// the fade s²(3 - 2s) alone.
// [/limb_fade]
float limb_fade(float opacity, float mu, float width) {
    return opacity;
}
