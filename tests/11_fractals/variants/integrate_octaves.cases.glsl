// right, in its pictures too
float integrate_octaves(float first_m, float lacunarity, float footprint_m, float most) {
    if (footprint_m > 0.0 && footprint_m < first_m) {
        float n = log(0.5 * first_m / footprint_m) / log(lacunarity);
        if (n + 1.0 >= most) return most;
        if (n >= 0.0) return n + 1.0;
        return 1.0;
    }
    return footprint_m > 0.0 ? 1.0 : most;
}
