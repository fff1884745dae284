// Exercise 11.integrate_octaves: no more octaves than can be seen from here.
// Until you fill it in, there are as many as there can be.

// [integrate_octaves]
// How many octaves are worth computing for a pixel, or a vertex, that stands for `footprint_m` metres of ground (0 or more).
// Octave 0 has waves of `first_m` metres (above 0), each next one waves shorter by the factor `lacunarity` (above 1). What
// is shorter than two footprints cannot be shown: it flickers. The result has a fraction, that nothing pops: it is n + 1
// where the waves of an octave n, or of one between two, are just two footprints long. At least 1, at most `most` (1 to 16),
// also for a footprint of 0 or of all the ground. A vertex shader has no dFdx to ask for its footprint: who calls this
// must know it.
// [/integrate_octaves]
float integrate_octaves(float first_m, float lacunarity, float footprint_m, float most) {
    return most;
}
