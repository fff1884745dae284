// Visibility test of objects; visible ones get a rank within their workgroup.
#include "06_deferred/culling_data.h"

layout(local_size_x = 256) in;

// Objects to list: all in the view, those visible in the previous frame, or the remaining ones.
#define SEEN 0
#define SEEN_BEFORE 1
#define APPEARED 2

layout(scalar) uniform LookBlock { CullingView look; };
#include "06_deferred/box_is_out.glsl"
#include "06_deferred/is_hidden.glsl"

layout(scalar) readonly buffer ObjectBuffer { CulledObject objects[]; };
#if LISTS == APPEARED
layout(scalar) readonly buffer EarlierBuffer { uint earlier[]; };  // ranks of the first list
#endif
layout(scalar) writeonly buffer RankBuffer { uint ranks[]; };
layout(scalar) writeonly buffer SumBuffer { uint sums[]; };

shared uint running[LIST_GROUP];

bool is_outside(CulledObject object) {
    for (int i = 0; i < 6; ++i) {
#if CULLING_BOUNDS == CULLING_BOUNDS_SPHERE
        if (dot(look.planes[i].xyz, object.center) + look.planes[i].w < -object.radius) return true;
#else
        if (box_is_out(object.center, object.half_size, look.planes[i])) return true;
#endif
    }
    return false;
}

bool is_listed(uint i) {
    CulledObject object = objects[i];
#if LISTS == APPEARED
    if ((earlier[i] & DRAWN) != 0u) return false;
#endif
    if (object.radius < 0.0) return object.group != NO_GROUP;
    if (is_outside(object)) return false;
#if LISTS == SEEN
    return true;
#else
    return !is_hidden(object);
#endif
}

void main() {
    uint i = gl_GlobalInvocationID.x, lane = gl_LocalInvocationIndex;
    uint listed = i < look.objects && is_listed(i) ? 1u : 0u;
    running[lane] = listed;
    barrier();
    for (uint step = 1u; step < LIST_GROUP; step *= 2u) {  // prefix sum
        uint before = lane >= step ? running[lane - step] : 0u;
        barrier();
        running[lane] += before;
        barrier();
    }
    if (i < look.objects) ranks[i] = (running[lane] - listed) | (listed * DRAWN);
    if (lane == LIST_GROUP - 1u) sums[gl_WorkGroupID.x] = running[lane];
}
