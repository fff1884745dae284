// Shader data: a bounding-volume hierarchy over triangles, and their cut-outs.
#pragma once
#include <common/shared.h>

BEGIN_SHARED

// How many nodes a ray puts aside at most: no leaf lies deeper.
const uint BVH_STACK = 40u;
const uint BVH_LEAF = 4u;  // triangles that a leaf has at most

// [node]
// A box in world space. Its two children stand side by side; a leaf has triangles instead.
struct BvhNode {
    vec3 lower;  // metres
    uint first;  // of its children in the nodes, or of its triangles
    vec3 upper;
    uint count;  // of a leaf's triangles; 0: it has children
};
// [/node]

const uint NO_CUTOUT = 0xffffffffu;

struct RayTriangle {
    vec3 a, b, c;  // metres, world space
    uint cutout;   // its place in the cutouts; NO_CUTOUT: nothing is cut out of it
};

// A triangle with holes: texture coordinates (v = 0 is the bottom row) and two masks; their product is its alpha.
struct RayCutout {
    vec2 a, b, c;
    uint color_mask, opacity_mask;
    float cutoff;  // below 0: the frame's
};

// A texture's alpha, 0 to 255, four texels in a word, rows from the top.
struct RayMask {
    uint first;  // word
    uint width, height;
};

// Ray settings of one frame.
struct RayState {
    float offset_m;                 // along the normal, from a surface to where its rays begin
    float cutoff;                   // lower alphas are holes
    uint first_sample;              // of this frame in the sequence
    uint color_cuts, opacity_cuts;  // 1: these masks cut holes; 0: they do not
    float wobble, scroll, time_s;   // for moving_uv()
};

END_SHARED
