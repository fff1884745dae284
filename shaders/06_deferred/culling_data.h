// Shader data of culling: objects, and groups drawn by one call.
#pragma once
#include <common/shared.h>

BEGIN_SHARED

// World-space bounds of an object.
struct CulledObject {
    vec3 center;     // metres
    float radius;    // radius of the box's bounding sphere, metres; below 0: unknown, always drawn
    vec3 half_size;  // half size of the box, metres
    uint group;      // draw group, or NO_GROUP
};

// Consecutive objects with equal mesh and textures.
struct DrawGroup {
    uint first, count;  // range of objects
    uint first_index, index_count;
};

// Layout of VkDrawIndexedIndirectCommand.
struct DrawCommand {
    uint index_count, instances, first_index;
    int vertex_offset;
    uint first_instance;
};

// Culling view; planes point inwards.
struct CullingView {
    vec4 planes[6];
    mat4 to_clip;         // world to the pyramid's clip space
    vec2 pyramid_pixels;  // size of the depth image, pixels
    int pyramid_levels;   // 0: no pyramid
    uint objects, groups;
};

const uint NO_GROUP = 0xffffffffu;  // group of objects drawn elsewhere
const uint DRAWN = 0x80000000u;     // bit of a rank: listed
const uint LIST_GROUP = 256u;       // objects per workgroup
const uint PYRAMID_STEP = 5u;       // pyramid levels per dispatch

END_SHARED
