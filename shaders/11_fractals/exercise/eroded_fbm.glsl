// Exercise 11.eroded_fbm: a landscape, whose steep places are worn smooth, and its slope.
// Until you fill it in, there is one octave.
#include "11_fractals/noise_jet.glsl"

// [eroded_fbm]
// (height, its derivative by offset.x, by offset.y) of a sum of octaves k = 0, 1, 2 ... below `octaves` (0 to 16, a number
// with a fraction: the last octave counts with that share, min(octaves - k, 1), in all that follows). In each octave:
//     d += share * gradient of the noise                 by the octave's own coordinates; d begins with 0
//     height += gain^k * share * noise / (1 + erosion * dot(d, d))
// settle(cell, offset) brings a place's offset to 0 to 1, noise_jet(cell, offset) gives value, gradient and hessian there,
// and next_octave(cell, offset) leads on: in the next octave the coordinates are finer * those of this one, and so a
// gradient g of octave k by its own coordinates is g * scale by offset, scale being the k-th power of `finer`.
// The derivative is that of all of this: d depends on the place, too, and the weight with it. d is not the slope.
// [/eroded_fbm]
vec3 eroded_fbm(ivec2 cell, vec2 offset, float octaves, float erosion, float gain) {
    settle(cell, offset);
    NoiseJet noise = noise_jet(cell, offset);
    return vec3(noise.value, noise.gradient);
}
