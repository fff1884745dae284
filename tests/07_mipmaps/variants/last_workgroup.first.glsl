// wrong: made before all tiles were there
layout(scalar) coherent buffer FinishedBuffer { uint finished[]; };

shared bool is_last;

bool is_last_workgroup(int layer, uint workgroups) {
    if (gl_LocalInvocationIndex == 0) {
        memoryBarrierBuffer();
        is_last = atomicAdd(finished[layer], 1u) == 0u;
    }
    barrier();
    memoryBarrierBuffer();
    return is_last;
}
