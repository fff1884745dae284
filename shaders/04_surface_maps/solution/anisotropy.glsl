// Solution of 04.anisotropy.

// EXT_texture_filter_anisotropic.
vec4 footprint_reads(vec2 across, vec2 down, float limit) {
    float a = length(across), d = length(down);
    float longer = max(max(a, d), 1e-6), shorter = max(min(a, d), 1.0);
    float n = clamp(ceil(longer / shorter), 1.0, limit);
    return vec4(a < d ? down : across, n, log2(longer / n));
}
