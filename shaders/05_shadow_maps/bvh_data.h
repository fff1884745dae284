// Shader data: a bounding-volume hierarchy over triangles, and their cut-outs.
#pragma once
#include <common/shared.h>

BEGIN_SHARED

// Stack size of a traversal: the maximum depth of a leaf.
const uint BVH_STACK = 40u;
const uint BVH_LEAF = 4u;  // maximum number of triangles in a leaf

// Node: a world-space box with two adjacent children, or a leaf with triangles.
struct BvhNode {
    vec3 lower;  // metres
    uint first;  // index of the first child or triangle
    vec3 upper;
    uint count;  // number of triangles; 0: inner node
};

const uint NO_CUTOUT = 0xffffffffu;

struct RayTriangle {
    vec3 a, b, c;  // metres, world space
    uint cutout;   // index of its cut-out, or NO_CUTOUT
};

// Cut-out of a triangle: alpha is the product of its corners' and of two masks. Coordinates have v = 0 at the bottom row.
struct RayCutout {
    vec3 alpha;  // of the corners
    vec2 color_uv[3], opacity_uv[3];
    uint color_mask, opacity_mask;
    float cutoff;  // below 0: the frame's
};

const uint MASK_REPEATS = 0u;
const uint MASK_MIRRORS = 1u;
const uint MASK_CLAMPS = 2u;

// Alpha mask: 0 to 255, four texels a word, rows from the top.
struct RayMask {
    uint first;  // index of the first word
    uint width, height;
    uint wrap_u, wrap_v;  // MASK_...
};

// Ray settings of one frame.
struct RayState {
    float offset_m;                 // offset of ray origins along the normal, metres
    float cutoff;                   // lower alphas are holes
    uint first_sample;              // index of the frame's first sample
    uint color_cuts, opacity_cuts;  // 1: masks from colour or opacity textures cut holes
    float wobble, scroll, time_s;   // for moving_uv()
};

END_SHARED
