// Exercise 11.integrate_octaves: the number of octaves that can be seen.
// Starter: it is the maximum.

// [integrate_octaves]
// Returns the number of octaves to compute for a pixel, or a vertex. `footprint_m`, 0 or
// more, is half the length of the shortest wave to be kept, in metres. Octave 0 has waves
// of `first_m` metres (above 0). In each further octave the waves are shorter by the factor
// `lacunarity` (above 1). Waves shorter than two footprints are left out, because they would
// flicker.
//
// The result has a fraction, so that no octave appears suddenly. It is n + 1 if the
// waves of octave n are exactly two footprints long, and n may be fractional too:
// octave n has waves of first_m / lacunarity^n metres. The result is at least 1 and at
// most `most` (1 to 16), also for a footprint of 0 or a very large one.
// [/integrate_octaves]
float integrate_octaves(float first_m, float lacunarity, float footprint_m, float most) {
    return most;
}
