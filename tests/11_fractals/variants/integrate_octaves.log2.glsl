// right, in its pictures too
float integrate_octaves(float first_m, float lacunarity, float footprint_m, float most) {
    // log(first / (2 footprint)) / log(lacunarity) + 1: the octave whose wave is two footprints long.
    if (footprint_m <= 0.5 * first_m * pow(lacunarity, -most)) return most;
    return clamp(1.0 - log2(2.0 * footprint_m / first_m) / log2(lacunarity), 1.0, most);
}
