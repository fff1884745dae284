// Exercise 11.eroded_fbm: a landscape whose steep slopes are worn smooth, and its gradient.
// Starter: there is one octave.
#include "11_fractals/noise_jet.glsl"

// [eroded_fbm]
// Returns (height, its derivative by offset.x, its derivative by offset.y) of a sum of
// octaves k = 0, 1, 2 ... below `octaves`. `octaves` is 0 to 16 and may have a
// fraction: the last octave counts with the factor share = min(octaves - k, 1). For
// each octave, in this order:
//
//     d += share * gradient of the noise, by the octave's own coordinates (d begins as 0)
//     height += gain^k * share * noise / (1 + erosion * dot(d, d))
//
// Available are:
// - settle(cell, offset): brings the offset into 0 to 1 by changing the cell
// - noise_jet(cell, offset): value, gradient and hessian of the noise there
// - next_octave(cell, offset): converts the position to the coordinates of the next
//   octave, which are `finer` (a matrix) times those of this one
//
// A gradient g by the coordinates of octave k becomes g * scale by the original offset,
// where scale is the k-th power of `finer`.
//
// The derivative is that of the whole formula. d depends on the position as well,
// through the second derivatives of the noise, and with it the weight
// 1 / (1 + erosion * dot(d, d)). d itself is not the slope.
// [/eroded_fbm]
vec3 eroded_fbm(ivec2 cell, vec2 offset, float octaves, float erosion, float gain) {
    settle(cell, offset);
    NoiseJet noise = noise_jet(cell, offset);
    return vec3(noise.value, noise.gradient);
}
