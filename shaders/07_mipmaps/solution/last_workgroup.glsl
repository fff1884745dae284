// Solution of 07.last_workgroup.
layout(scalar) coherent buffer FinishedBuffer { uint finished[]; };

shared bool is_last;

bool is_last_workgroup(int layer, uint workgroups) {
    if (gl_LocalInvocationIndex == 0) {
        memoryBarrierBuffer();  // this thread's writes are visible before it is counted
        is_last = atomicAdd(finished[layer], 1u) == workgroups - 1u;
    }
    barrier();              // all threads know
    memoryBarrierBuffer();  // and read after the count, not before
    return is_last;
}
