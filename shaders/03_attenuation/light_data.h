// Shader data of lights of all kinds, and of the grid of cells that lists them.
#pragma once
#include <common/shared.h>

#include "common/view_rays.h"

BEGIN_SHARED

const uint LIGHT_DIRECTIONAL = 0u;
const uint LIGHT_POINT = 1u;
const uint LIGHT_SPOT = 2u;

struct LightData {
    vec3 position;    // metres, world space; point and spot
    float range;      // end of a ranged falloff, metres; point and spot
    vec3 direction;   // unit length, world space, the way the light travels; directional and spot
    uint kind;        // LIGHT_...
    vec3 radiance;    // linear: colour times intensity, at the surface (directional) or at 1 m
    float softness;   // softness of a spot's edge, 0 to 1
    float cos_inner;  // cosines of a spot's half angles; cos_inner >= cos_outer
    float cos_outer;
    float radius;    // lamp radius in metres, or tangent of its angular radius (directional); 0: a point
    vec3 half_tube;  // from a tube's centre to one end, metres; zero: a disc facing the shaded point
};

// Culling radius of a point or spot light in metres: its range or, with a threshold above 0, the distance at which an
// unbounded inverse square has fallen to that radiance.
SHARED_FUNCTION float influence_radius(LightData light, float threshold) {
    float brightest = max(light.radiance.x, max(light.radiance.y, light.radiance.z));
    return threshold > 0.0f ? sqrt(brightest / threshold) : light.range;
}

// Grid of screen tiles, each one cell or several depth slices.
// One bit per cell and light: bit i of masks[m * cells + cell] is light 32 m + i. Bit j of groups[g * cells + cell] is
// set if mask 32 g + j has any; other masks are undefined.
const uint LIGHTS_PER_MASK = 32u;
const uint LIGHTS_PER_GROUP = 1024u;

struct GridView {
    vec3 eye;                         // metres, world space
    vec3 right, up, forward;          // camera axes, unit length
    vec2 tan_half;                    // tangents of half the field of view, across and down
    float inverse_near, inverse_far;  // 1/m; inverse_far is 0 where the far plane is at infinity
    vec2 size;                        // pixels
    vec2 whole;                       // size of the whole picture, pixels
    vec2 origin;                      // offset within the whole picture, pixels
    uvec2 tiles;
    uint tile_px;   // tile width
    uint slices;    // slices per tile
    float first_m;  // slice i ends at first_m * exp((i + 1) / slices_per_log)
    float slices_per_log;
    float threshold;  // for influence_radius()
};

#ifndef __cplusplus
layout(scalar) uniform LightsGridBlock { GridView lights_grid; };

uint cell_count() { return lights_grid.tiles.x * lights_grid.tiles.y * lights_grid.slices; }

// Distance along the view, metres.
float view_depth(float depth) { return depth_to_metres(depth, lights_grid.inverse_near, lights_grid.inverse_far); }
#endif

END_SHARED
