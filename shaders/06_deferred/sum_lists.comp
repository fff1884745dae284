// Exclusive prefix sum of the workgroups' counts, in one workgroup.
#include "06_deferred/culling_data.h"

layout(local_size_x = 256) in;

layout(scalar) buffer SumBuffer { uint sums[]; };
layout(scalar) writeonly buffer TotalBuffer { uint total; };
layout(scalar) uniform LookBlock { CullingView look; };

shared uint running[LIST_GROUP];

void main() {
    uint lane = gl_LocalInvocationIndex, count = (look.objects + LIST_GROUP - 1u) / LIST_GROUP;
    uint each = (count + LIST_GROUP - 1u) / LIST_GROUP, first = lane * each, own = 0u;
    for (uint k = first; k < min(first + each, count); ++k) own += sums[k];
    running[lane] = own;
    barrier();
    for (uint step = 1u; step < LIST_GROUP; step *= 2u) {
        uint before = lane >= step ? running[lane - step] : 0u;
        barrier();
        running[lane] += before;
        barrier();
    }
    uint before = running[lane] - own;
    for (uint k = first; k < min(first + each, count); ++k) {
        uint here = sums[k];
        sums[k] = before;
        before += here;
    }
    if (lane == LIST_GROUP - 1u) total = running[lane];
}
