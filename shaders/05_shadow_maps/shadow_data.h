// Shader data of shadows: lights, their views, map settings.
#pragma once
#include <common/shared.h>

BEGIN_SHARED

const uint NO_LAYER = 0xffffffffu;

// Unused margin at each side of a map, as a share of its width, for filters to read.
const float MAP_MARGIN = 1.0f / 16.0f;

// View of a shadow map.
struct ShadowView {
    mat4 to_clip;        // world to clip space: y down, depth 1 near and 0 far; w: 1, or distance along the view
    mat4 plane_to_clip;  // inverse transpose of to_clip, for planes
    vec2 to_distance;    // distance of depth d along the view, metres: x + y * d, or 1 / (x + y * d)
    float near, far;     // metres along the view
    float texel;         // texel width at w = 1, metres
    uint perspective;    // 1: to_distance gives the reciprocal
    uint layer;          // layer of the map, or NO_LAYER without casters
};

// Shadow of a light. Views: one per cascade of a directional light, finest first; one of a spot; six of a point light:
// +x, -x, +y, -y, +z, -z.
struct ShadowLight {
    vec3 position;  // metres, world space; unused by directional lights
    uint kind;      // LIGHT_...; LIGHT_POINT for spots too wide for one view
    uint first_view;
    uint views;  // 0: no shadow
    float size;  // lamp diameter, metres; directional: 2 tan of the angular radius
};

// Camera data for filter widths, and the limits of the constant bias.
struct ShadowEye {
    vec3 position;      // metres, world space
    float pixel;        // pixel width at 1 m, metres
    float bias_texels;  // upper limit of the constant bias, in texels
    float least_bias;   // its lower limit, as a fraction of the view's depth range
};

#ifndef __cplusplus
// Depth maps, one layer per view; 0 outside: nothing nearer to the light.
int map_texels();                       // width and height in texels
float read_depth(vec2 uv, uint layer);  // depth of the texel at uv
vec4 gather_depths(vec2 uv,
                   uint layer);  // of the four texels that meet in the corner nearest to uv: x lower left, y lower
                                 // right, z upper right, w upper left, where lower is the greater v

// Receiver point in map space.
struct Receiver {
    vec3 place;  // map coordinates and depth, as from light_clip_position()
    vec2 slope;  // change of the surface's depth over the map's width along u and v; 0: unused
};

// Depth of the receiver's plane at a point of the map; 0, the map's clear value, beyond the far plane.
float plane_depth(Receiver r, vec2 uv) { return max(r.place.z + dot(r.slope, uv - r.place.xy), 0.0); }

// Depths of the receiver's plane at the centres of the four texels around uv, in the order of gather_depths().
vec4 plane_depths(Receiver r, vec2 corner) {
    vec2 half_texel = r.slope * (0.5 / float(map_texels()));
    float middle = r.place.z + dot(r.slope, corner - r.place.xy);
    return max(middle + vec4(half_texel.y - half_texel.x, half_texel.x + half_texel.y, half_texel.x - half_texel.y,
                             -half_texel.x - half_texel.y),
               0.0);
}
#endif

END_SHARED
