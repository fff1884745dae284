// Exercise 17.limb_fade: clouds at the edge of the planet.
// As it stands they are as opaque there as from above, and their shell's outline hangs over the ground's.

// [limb_fade]
// `opacity` (0 to 1) is what a layer of clouds hides when seen from straight above. At `mu`, the cosine of the angle
// between the layer's normal and the direction to the camera, the way through it is 1 / mu times as long: it lets through
// (1 - opacity)^(1 / mu). But the shell is drawn where no ground is behind it, at mu near 0, and there a thin layer would
// become a wall outside of the air. So the result is 1 - (1 - opacity)^(1 / mu) times s²(3 - 2s), s = mu / `width` held to
// 0 to 1; `width` is above 0. At mu <= 0 the layer is seen from below, through the planet: 0. What hides nothing stays so at
// any mu, and what is opaque (1) hides everything, up to the fade.
// [/limb_fade]
float limb_fade(float opacity, float mu, float width) {
    return opacity;
}
