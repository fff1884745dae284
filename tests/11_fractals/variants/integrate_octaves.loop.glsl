// wrong: integrate_octaves(
float integrate_octaves(float first_m, float lacunarity, float footprint_m, float most) {
    float octaves = 1.0;
    for (float wave = first_m / lacunarity; wave >= 2.0 * footprint_m && octaves < most; wave /= lacunarity) ++octaves;
    return octaves;
}
