// Solution of 03.tile_lights. The bit patterns of positive floats sort like the floats.
shared uint farthest_bits, nearest_bits;
shared uint tile_masks[32];

vec2 tile_depth_range(uint local) {
    if (local == 0u) {
        farthest_bits = floatBitsToUint(1.0);
        nearest_bits = 0u;
    }
    barrier();  // no update before the initial values are set
    for (uint pixel = local; pixel < tile_pixels(); pixel += TILE_INVOCATIONS) {
        uint bits = floatBitsToUint(tile_depth(pixel));
        if (bits == 0u) continue;
        atomicMin(farthest_bits, bits);
        atomicMax(nearest_bits, bits);
    }
    barrier();  // no read before all updates are done
    return vec2(uintBitsToFloat(farthest_bits), uintBitsToFloat(nearest_bits));
}

void find_tile_lights(uint local, uint group) {
    barrier();  // no clear while another invocation still reads
    if (local < 32u) tile_masks[local] = 0u;
    barrier();
    uint first = 1024u * group, end = min(first + 1024u, light_count());
    for (uint light = first + local; light < end; light += TILE_INVOCATIONS)
        if (light_reaches_tile(light)) atomicOr(tile_masks[(light - first) / 32u], 1u << (light - first) % 32u);
    barrier();
}
