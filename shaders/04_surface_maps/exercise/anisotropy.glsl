// Exercise 04.anisotropy: how many reads a long footprint takes, and of which level.
// Starter: one read, of the level that suits the longer side. That is trilinear filtering.

// [anisotropy]
// A pixel's footprint on a map has two sides: `across` and `down`, the changes of the
// texture coordinates from this pixel to its two neighbours, in texels. The map is read
// n times, evenly along the longer side. Returns that side in xy, n in z, and the mip
// level of each read in w.
//
// n is the length of the longer side divided by that of the shorter one, rounded up,
// but at most `limit` (1 to 16, an integer) and at least 1. A shorter side below one
// texel counts as one texel: reads that are closer to one another would return the same
// texels again. Each read stands for an n-th of the longer side, so its level is the
// one whose texels are as long as that. Texels of level k are 2^k texels long; a level
// below 0 is right for lengths below 1. A longer side below 0.000001 texels, as on a
// surface without texture coordinates, counts as 0.000001 texels long.
// [/anisotropy]
vec4 footprint_reads(vec2 across, vec2 down, float limit) {
    vec2 longer = length(across) < length(down) ? down : across;
    return vec4(longer, 1.0, log2(max(length(longer), 1e-6)));
}
