// Lights of every kind as shaders read them, in one buffer; and the grid of cells into which they are sorted.
#pragma once
#include <common/shared.h>

#include "common/view_rays.h"

BEGIN_SHARED

const uint LIGHT_DIRECTIONAL = 0u;
const uint LIGHT_POINT = 1u;
const uint LIGHT_SPOT = 2u;

// [light]
struct LightData {
    vec3 position;    // metres, world space; point and spot
    float range;      // metres: beyond it a ranged falloff is 0; point and spot
    vec3 direction;   // unit length, world space, the way the light travels; directional and spot
    uint kind;        // LIGHT_...
    vec3 radiance;    // linear: colour times intensity, at the surface (directional) or at 1 m
    float softness;   // of a spot's cone, 0 to 1
    float cos_inner;  // of the half angles of a spot's cone; cos_inner >= cos_outer
    float cos_outer;
    float radius;    // of the lamp: metres, or the tangent of half the angle that it fills (directional); 0: a point
    vec3 half_tube;  // metres, from the middle of a tube to an end; no length: the lamp is a disc that faces the point
};
// [/light]

// [influence_radius]
// How far a point or spot light is taken to reach, in metres: its range or, with a threshold above 0, the distance at
// which an inverse square that never ends has fallen to that radiance.
SHARED_FUNCTION float influence_radius(LightData light, float threshold) {
    float brightest = max(light.radiance.x, max(light.radiance.y, light.radiance.z));
    return threshold > 0.0f ? sqrt(brightest / threshold) : light.range;
}
// [/influence_radius]

// The grid: tiles of the screen, each one cell or cut into slices of depth.
// [masks]
// One bit for each cell and light that may reach it: bit i of masks[m * cells + cell] is light 32 m + i. Bit j of
// groups[g * cells + cell] is set if mask 32 g + j has any; other masks are undefined.
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

#ifndef __cplusplus
layout(scalar) uniform LightsGridBlock { GridView lights_grid; };

uint cell_count() { return lights_grid.tiles.x * lights_grid.tiles.y * lights_grid.slices; }

// Metres in front of the eye.
float view_depth(float depth) { return depth_to_metres(depth, lights_grid.inverse_near, lights_grid.inverse_far); }
#endif

END_SHARED
