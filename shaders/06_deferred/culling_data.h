// Objects to be culled, and the groups that one draw call draws; GLSL and C++.
#pragma once
#include <common/shared.h>

BEGIN_SHARED

// Bounds of an object, world space.
struct CulledObject {
    vec3 center;     // metres
    float radius;    // of a sphere around the box, metres; below 0: nothing is known, always drawn
    vec3 half_size;  // of the box, metres
    uint group;      // draw group, or NO_GROUP
};

// Neighbours with one mesh and one set of textures.
struct DrawGroup {
    uint first, count;  // objects
    uint first_index, index_count;
};

// As VkDrawIndexedIndirectCommand.
struct DrawCommand {
    uint index_count, instances, first_index;
    int vertex_offset;
    uint first_instance;
};

// A view of the objects. Planes point inwards.
struct CullingView {
    vec4 planes[6];
    mat4 to_clip;         // of the pyramid
    vec2 pyramid_pixels;  // size of the picture that it was made of
    int pyramid_levels;   // 0: there is none
    uint objects, groups;
};

const uint NO_GROUP = 0xffffffffu;  // of an object that is drawn otherwise
const uint DRAWN = 0x80000000u;     // bit of a rank: the object is in the list
const uint LIST_GROUP = 256u;       // objects for each workgroup
const uint PYRAMID_STEP = 5u;       // levels of a depth pyramid in one dispatch

END_SHARED
