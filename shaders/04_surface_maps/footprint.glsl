// Reads that an elongated footprint takes (EXT_texture_filter_anisotropic): as many as it is longer than wide, up to a
// limit, in a row along its longer side.

// Footprint of a pixel from two derivatives of the texture coordinates, in texels. xy: its longer side, texels; z: the
// number of reads; w: the mip level of each, that of the piece of the longer side that it stands for.
vec4 footprint_reads(vec2 across, vec2 down, float limit) {
    vec2 longer = dot(across, across) < dot(down, down) ? down : across;
    vec2 shorter = dot(across, across) < dot(down, down) ? across : down;
    float size = max(length(longer), 1e-6);
    // Reads less than a texel apart would give the same texels again.
    float reads = clamp(ceil(size / max(length(shorter), 1.0)), 1.0, limit);
    return vec4(longer, reads, log2(size / reads));
}
