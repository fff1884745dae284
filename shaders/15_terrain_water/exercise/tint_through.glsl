// Exercise 15.tint_through: the light that coloured glass lets through.
// Starter: glass takes the same share of every colour, so a red pane is grey.

// [tint_through]
// Layers of glass lie one behind another. `passed`: the share of the light from behind that
// passes through all layers in front of the next one, in red, green and blue. `alpha`: the share
// of its area that the next layer covers with opaque matter, from which no light passes. `tint`:
// the share of the remaining light that its glass lets through, by channel. All are 0 to 1.
// Returns the share that passes through all layers up to and including the next one, by channel.
// Tolerance: 1e-6.
// [/tint_through]
vec3 tint_through(vec3 passed, float alpha, vec3 tint) {
    return passed * (1.0 - alpha);
}
