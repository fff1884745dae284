// Puts pixels on the list. One atomic operation on the device's memory for a workgroup, not for a pixel.
#include "13_mlaa/work.glsl"

layout(scalar) writeonly buffer ListBuffer { uint listed[]; };
layout(scalar) writeonly buffer NextWorkBuffer { Work next_work; };  // of the next frame, which finds nothing listed
shared uint listed_here, listed_from;

// The whole workgroup calls both, once: the first before one of its barriers, the second behind it.
void begin_list() {
    if (gl_GlobalInvocationID.xy == uvec2(0u)) {
        next_work.groups[0] = 0u;
        next_work.listed_count = 0u;
        next_work.changed_count = 0u;
    }
    if (gl_LocalInvocationIndex == 0u) listed_here = 0u;
}

void put_on_list(bool wanted, ivec2 pixel) {
    uint own = wanted ? atomicAdd(listed_here, 1u) : 0u;
    barrier();
    if (gl_LocalInvocationIndex == 0u && listed_here > 0u) {
        listed_from = atomicAdd(work.listed_count, listed_here);
        uint groups = (listed_from + listed_here + listed_threads - 1u) / listed_threads;
        atomicMax(work.groups[0], min(groups, most_groups));
    }
    barrier();
    if (wanted) listed[listed_from + own] = pack_pixel(pixel);
}
