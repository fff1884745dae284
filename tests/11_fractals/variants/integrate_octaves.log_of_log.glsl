// right, in its pictures too
float integrate_octaves(float first_m, float lacunarity, float footprint_m, float most) {
    if (footprint_m <= 0.0) return most;
    float n = log(first_m / (2.0 * footprint_m)) / log(lacunarity) + 1.0;
    return clamp(n, 1.0, most);
}
