// right
layout(scalar) coherent buffer FinishedBuffer { uint finished[]; };

shared uint before;

void publish() { memoryBarrier(); }

bool is_last_workgroup(int layer, uint workgroups) {
    publish();
    barrier();
    if (gl_LocalInvocationID.x == 5u) before = atomicAdd(finished[layer], 1u);
    groupMemoryBarrier();
    barrier();
    publish();
    return before + 1u == workgroups;
}
