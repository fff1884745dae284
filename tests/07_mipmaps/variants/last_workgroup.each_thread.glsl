// wrong: texels is
layout(scalar) coherent buffer FinishedBuffer { uint finished[]; };

shared bool is_last;

bool is_last_workgroup(int layer, uint workgroups) {
    memoryBarrierBuffer();
    bool mine = atomicAdd(finished[layer], 1u) == workgroups - 1u;
    if (gl_LocalInvocationIndex == 0) is_last = false;
    barrier();
    if (mine) is_last = true;
    barrier();
    memoryBarrierBuffer();
    return is_last;
}
