// wrong: layer
layout(scalar) coherent buffer FinishedBuffer { uint finished[]; };

shared bool is_last;

bool is_last_workgroup(int layer, uint workgroups) {
    if (gl_LocalInvocationIndex == 0) {
        memoryBarrierBuffer();
        is_last = atomicAdd(finished[0], 1u) == workgroups - 1u;
    }
    barrier();
    memoryBarrierBuffer();
    return is_last;
}
