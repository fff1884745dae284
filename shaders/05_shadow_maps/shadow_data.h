// Shader data of a frame's shadows: lights, their views, and settings of a view's map.
#pragma once
#include <common/shared.h>

BEGIN_SHARED

const uint NO_LAYER = 0xffffffffu;

// Margin at each side of a map, as a share of it, without shadow queries: a filter may be as wide.
const float MAP_MARGIN = 1.0f / 16.0f;

// [shadow_view]
// One picture of depth from a light.
struct ShadowView {
    mat4 to_clip;        // world to clip space: y down, depth 1 near and 0 far; w: 1, or the distance along the view
    mat4 plane_to_clip;  // its inverse transpose: moves planes
    vec2 to_distance;    // of a depth d the distance along the view, in metres, is x + y * d, or 1 / (x + y * d)
    float near, far;     // metres along the view
    float texel;         // width of a texel at w = 1, in metres
    uint perspective;    // 1: to_distance gives the inverse
    uint layer;          // of the map; NO_LAYER: nothing casts a shadow in it
};
// [/shadow_view]

// [shadow_light]
// The shadow of one light. A directional light has a view for each cascade, the finest first; a spot has one; a point
// has six: +x, -x, +y, -y, +z, -z.
struct ShadowLight {
    vec3 position;  // metres, world space; not of a directional light
    uint kind;      // LIGHT_...: a spot that is too wide for one view is a point here
    uint first_view;
    uint views;  // 0: it casts no shadow
    float size;  // of the lamp: its diameter in metres; directional: 2 tan of half the angle it fills
};
// [/shadow_light]

// The eye's part in it.
struct ShadowEye {
    vec3 position;  // metres, world space
    float pixel;    // width of a pixel at a distance of 1 m, in metres
};

#ifndef __cplusplus
// The map of depths, a layer for each view; outside of it is 0: nothing is nearer to the light.
int map_texels();                       // along u and along v
float read_depth(vec2 uv, uint layer);  // of the texel that holds this place
vec4 gather_depths(vec2 uv,
                   uint layer);  // of the four texels that meet in the corner nearest to uv: x lower left, y lower
                                 // right, z upper right, w upper left, where lower is the greater v

// [receiver_struct]
// A point as a map sees it.
struct Receiver {
    vec3 place;  // as light_clip_position says
    vec2 slope;  // by how much depth changes on the surface, over the map's width along u and along v; 0: not asked for
};
// [/receiver_struct]

// The surface's own depth at a point of the map. Beyond the far plane it is 0, the map's value there: nothing blocks.
float plane_depth(Receiver r, vec2 uv) { return max(r.place.z + dot(r.slope, uv - r.place.xy), 0.0); }

// [plane_depths]
// The same in the middle of those four texels, for a corner at uv.
vec4 plane_depths(Receiver r, vec2 corner) {
    vec2 half_texel = r.slope * (0.5 / float(map_texels()));
    float middle = r.place.z + dot(r.slope, corner - r.place.xy);
    return max(middle + vec4(half_texel.y - half_texel.x, half_texel.x + half_texel.y, half_texel.x - half_texel.y,
                             -half_texel.x - half_texel.y),
               0.0);
}
// [/plane_depths]
#endif

END_SHARED
