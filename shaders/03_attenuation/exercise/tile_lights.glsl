// Exercise 03.tile_lights: the depth range and the lights of a screen tile, found by one workgroup.
// Starter: every light is in every tile: the picture is right, and nothing is saved.

// [tile_lights]
// One workgroup of TILE_INVOCATIONS invocations runs these functions together for one tile.
// `local` numbers the invocations from 0; use it, not gl_LocalInvocationIndex. The
// invocations share the variables declared `shared`; you may add more.
//
//     vec2 tile_depth_range(uint local)
// Returns (farthest, nearest): the smallest and the largest tile_depth(p) above 0 among the
// pixels p from 0 to tile_pixels() - 1, the same result to every invocation. The pixels may
// be more or fewer than the invocations. Depths run from 0 to 1, reversed; 0 is the
// background and does not count. If the whole tile is background, the result is (1, 0).
//
//     void find_tile_lights(uint local, uint group)
// Finds which of the lights 1024 * group to 1024 * group + 1023 reach the tile. Bit i of
// tile_masks[m], with m and i from 0 to 31, becomes 1 if
// light_reaches_tile(1024 * group + 32 * m + i), and 0 otherwise. There are light_count()
// lights: the bits of numbers beyond them are 0, and light_reaches_tile must not be called
// for them.
//
// The function is called for one group after the other. As soon as it returns to an
// invocation, that invocation reads all of tile_masks, so they must be complete. It goes on
// reading until it calls the function for the next group: clear no mask before all
// invocations have done so.
// [/tile_lights]
shared uint farthest_bits, nearest_bits;  // atomicMin and atomicMax work on integers; see floatBitsToUint
shared uint tile_masks[32];

vec2 tile_depth_range(uint local) {
    return vec2(1e-9, 1.0);
}

void find_tile_lights(uint local, uint group) {
    barrier();
    if (local < 32u) {
        uint first = 1024u * group + 32u * local, left = light_count() > first ? light_count() - first : 0u;
        tile_masks[local] = left < 32u ? (1u << left) - 1u : ~0u;
    }
    barrier();
}
