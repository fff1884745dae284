// Compaction of each group's listed objects, in order, and its draw command.
#include "06_deferred/culling_data.h"
#include "common/structs.h"

layout(local_size_x = 256) in;

layout(scalar) readonly buffer ObjectBuffer { CulledObject objects[]; };
layout(scalar) readonly buffer GroupBuffer { DrawGroup groups[]; };
layout(scalar) readonly buffer RankBuffer { uint ranks[]; };
layout(scalar) readonly buffer SumBuffer { uint sums[]; };
layout(scalar) readonly buffer TotalBuffer { uint total; };
layout(scalar) readonly buffer InstanceBuffer { Instance instances[]; };
layout(scalar) writeonly buffer ListedInstanceBuffer { Instance listed_instances[]; };
layout(scalar) writeonly buffer DrawBuffer { DrawCommand draws[]; };
layout(scalar) uniform LookBlock { CullingView look; };

// [draws]
// Number of listed objects before object i.
uint listed_before(uint i) { return i < look.objects ? sums[i / LIST_GROUP] + (ranks[i] & ~DRAWN) : total; }

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i < look.groups) {
        DrawGroup g = groups[i];
        uint count = listed_before(g.first + g.count) - listed_before(g.first);
        draws[i] = DrawCommand(g.index_count, count, g.first_index, 0, g.first);
    }
    if (i >= look.objects || (ranks[i] & DRAWN) == 0u) return;
    uint first = groups[objects[i].group].first;
    listed_instances[first + listed_before(i) - listed_before(first)] = instances[i];
}
// [/draws]
