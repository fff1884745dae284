// The grid of cells into which lights are sorted: tiles of the screen, each one cell or cut into slices of depth.
#pragma once
#include "common/shared.h"

BEGIN_SHARED

// [masks]
// For each cell one bit per light says whether the light may reach it: bit i of masks[m * cells + cell] is light
// 32 m + i. One bit per mask says whether the mask has any: bit j of groups[g * cells + cell] is mask 32 g + j. A mask
// whose bit is 0 holds nothing that was written.
const uint LIGHTS_PER_MASK = 32u;
const uint LIGHTS_PER_GROUP = 1024u;
// [/masks]

struct GridView {
    vec3 eye;                         // metres, world space
    vec3 right, up, forward;          // unit length: the camera's axes
    vec2 tan_half;                    // of half the field of view, across and down
    float inverse_near, inverse_far;  // 1/m; inverse_far is 0 where the far plane is at infinity
    vec2 size;                        // pixels
    vec2 whole;                       // pixels of the picture that this one is a part of
    vec2 origin;                      // of this one in it, pixels
    uvec2 tiles;
    uint tile_px;   // side of a tile
    uint slices;    // of each tile
    float first_m;  // slice i ends at first_m * exp((i + 1) / slices_per_log)
    float slices_per_log;
    float threshold;  // for influence_radius()
};

END_SHARED
