// wrong: were told that they are the last
layout(scalar) coherent buffer FinishedBuffer { uint finished[]; };

shared bool is_last;

bool is_last_workgroup(int layer, uint workgroups) {
    if (gl_LocalInvocationIndex == 0) {
        memoryBarrierBuffer();  // what this thread has written is there before it is counted
        is_last = atomicAdd(finished[layer], 1u) >= max(workgroups, 2u) - 2u;
    }
    barrier();              // all threads know
    memoryBarrierBuffer();  // and read after the count, not before
    return is_last;
}
