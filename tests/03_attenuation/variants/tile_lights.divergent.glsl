// wrong: barriers
shared uint farthest_bits, nearest_bits;
shared uint tile_masks[32];

vec2 tile_depth_range(uint local) {
    if (local == 0u) {
        farthest_bits = floatBitsToUint(1.0);
        nearest_bits = 0u;
    }
    barrier();  // nobody adds to what is not set
    for (uint pixel = local; pixel < tile_pixels(); pixel += TILE_INVOCATIONS) {
        uint bits = floatBitsToUint(tile_depth(pixel));
        if (bits == 0u) continue;
        atomicMin(farthest_bits, bits);
        atomicMax(nearest_bits, bits);
    }
    barrier();  // nobody reads what is not complete
    return vec2(uintBitsToFloat(farthest_bits), uintBitsToFloat(nearest_bits));
}

void find_tile_lights(uint local, uint group) {
    barrier();  // nobody clears what another still reads
    if (local < 32u) { tile_masks[local] = 0u; barrier(); }
    barrier();
    uint first = 1024u * group, end = min(first + 1024u, light_count());
    for (uint light = first + local; light < end; light += TILE_INVOCATIONS)
        if (light_reaches_tile(light)) atomicOr(tile_masks[(light - first) / 32u], 1u << (light - first) % 32u);
    barrier();
}
