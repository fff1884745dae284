// Solution of 11.integrate_octaves.

float integrate_octaves(float first_m, float lacunarity, float footprint_m, float most) {
    // log(first / (2 footprint)) / log(lacunarity) + 1: the octave with a wavelength of two footprints.
    if (footprint_m <= 0.5 * first_m * pow(lacunarity, -most)) return most;
    return clamp(log(first_m / (2.0 * footprint_m)) / log(lacunarity) + 1.0, 1.0, most);
}
