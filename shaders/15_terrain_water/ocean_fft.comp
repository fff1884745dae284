// An inverse Fourier transform of 256 numbers in shared memory: each group takes a row or a column of two complex fields.
// T. Stockham's order (1966), which needs no bits reversed.
#include "15_terrain_water/water_data.h"

layout(local_size_x = 128) in;

#if VERTICAL
layout(rgba32f) readonly uniform image2DArray fields;
layout(rgba16f) writeonly uniform image2DArray moved;
layout(rgba16f) writeonly uniform image2DArray sloped;
#else
layout(rgba32f) uniform image2DArray fields;
#endif

shared vec4 line[2][OCEAN_TEXELS];

vec2 times(vec2 a, vec2 b) { return vec2(a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x); }

ivec3 place(uint i) {
#if VERTICAL
    return ivec3(gl_WorkGroupID.x, i, gl_WorkGroupID.y);
#else
    return ivec3(i, gl_WorkGroupID.x, gl_WorkGroupID.y);
#endif
}

void put(uint i, vec4 value) {
#if VERTICAL
    ivec3 at = place(i);
    if (at.z < 3)
        imageStore(moved, at, value);
    else
        imageStore(sloped, at - ivec3(0, 0, 3), value);
#else
    imageStore(fields, place(i), value);
#endif
}

// [ocean_fft]
void main() {
    uint j = gl_LocalInvocationID.x;
    line[0][j] = imageLoad(fields, place(j));
    line[0][j + 128u] = imageLoad(fields, place(j + 128u));
    barrier();
    uint from = 0u;
    for (uint stride = 1u; stride < OCEAN_TEXELS; stride *= 2u) {
        uint p = j / stride, q = j % stride;
        float angle = 6.2831853 * float(p * stride) / float(OCEAN_TEXELS);
        vec2 turn = vec2(cos(angle), sin(angle));
        vec4 a = line[from][j], b = line[from][j + 128u], d = a - b;
        uint to = 1u - from, even = q + 2u * stride * p;
        line[to][even] = a + b;
        line[to][even + stride] = vec4(times(d.xy, turn), times(d.zw, turn));
        from = to;
        barrier();
    }
    put(j, line[from][j]);
    put(j + 128u, line[from][j + 128u]);
}
// [/ocean_fft]
