// wrong: no barrier() after the count
layout(scalar) coherent buffer FinishedBuffer { uint finished[]; };

shared bool is_last;

bool is_last_workgroup(int layer, uint workgroups) {
    memoryBarrierBuffer();
    if (gl_LocalInvocationIndex == 0) is_last = atomicAdd(finished[layer], 1u) == workgroups - 1u;
    memoryBarrierBuffer();
    return is_last;
}
