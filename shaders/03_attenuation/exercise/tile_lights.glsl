// Exercise 03.tile_lights: a workgroup finds the lights of a tile, its invocations together.
// As it stands every light is in every tile: the picture is right, and nothing is saved.

// [tile_lights]
// TILE_INVOCATIONS invocations, one workgroup, run these functions at once. `local` counts them from 0: use it, and not
// gl_LocalInvocationIndex. They share what is declared `shared`; you may add to it.

// The least and the greatest tile_depth(p) above 0, for p from 0 to tile_pixels() - 1, which may be more or fewer than
// there are invocations: (farthest, nearest), the same for every invocation. Depths are from 0 to 1, reversed; 0 is the
// background, which does not count. Where all is background: (1, 0).
//     vec2 tile_depth_range(uint local)

// Which of the lights 1024 * group to 1024 * group + 1023 reach the tile: bit i of tile_masks[m] is 1 where
// light_reaches_tile(1024 * group + 32 * m + i), and 0 elsewhere, also for lights from light_count() on, of which nothing
// may be asked. Called for one group after the other. When it returns to an invocation, that one may read all of
// tile_masks, and nothing of it changes until every invocation has called it again.
//     void find_tile_lights(uint local, uint group)
// [/tile_lights]
shared uint farthest_bits, nearest_bits;  // atomicMin and atomicMax take whole numbers: what of floatBitsToUint?
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
