// right
shared uint tile_masks[32];
shared vec2 ranges[TILE_INVOCATIONS];

vec2 tile_depth_range(uint local) {
    vec2 mine = vec2(1.0, 0.0);
    for (uint pixel = local; pixel < tile_pixels(); pixel += TILE_INVOCATIONS) {
        float depth = tile_depth(pixel);
        if (depth > 0.0) mine = vec2(min(mine.x, depth), max(mine.y, depth));
    }
    ranges[local] = mine;
    for (uint half_count = TILE_INVOCATIONS / 2u; half_count > 0u; half_count /= 2u) {
        barrier();
        if (local < half_count) {
            vec2 other = ranges[local + half_count];
            ranges[local] = vec2(min(ranges[local].x, other.x), max(ranges[local].y, other.y));
        }
    }
    barrier();
    return ranges[0];
}

// No atomics: each of the first 32 makes a whole mask.
void find_tile_lights(uint local, uint group) {
    barrier();
    if (local < 32u) {
        uint mask = 0u, first = 1024u * group + 32u * local;
        for (uint i = 0u; i < 32u; ++i)
            if (first + i < light_count() && light_reaches_tile(first + i)) mask |= 1u << i;
        tile_masks[local] = mask;
    }
    barrier();
}
