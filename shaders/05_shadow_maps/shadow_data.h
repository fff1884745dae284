// What shaders know of the shadows of a frame.
#pragma once
#include "common/shared.h"

BEGIN_SHARED

const uint NO_LAYER = 0xffffffffu;

// The share of a map at each of its sides that holds no point whose shadow is asked for: a filter may be as wide.
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

END_SHARED
