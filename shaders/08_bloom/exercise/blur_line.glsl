// Exercise 08.blur_line: neighbouring pixels of a blur read nearly the same texels; read each once and share
// it.
// Starter: nothing is blurred.
#include "08_bloom/line_source.glsl"

// [blur_line]
// All 256 threads of a workgroup call this function together, once, with the same
// `start` and `radius` (0 to 896). Thread t, which is int(gl_LocalInvocationIndex),
// returns the sum over k from -radius to radius of
// weight_at(abs(k)) * texel(start + t + k).
//
// texel(i) is slow. The workgroup must call it exactly once for each of the 256 + 2
// radius texels that its threads need together. keep_texel(slot, value) stores a texel
// in shared memory for all threads, kept_texel(slot) reads it; slots are 0 to 2047.
//
// There are more texels than threads, so threads have to load several texels each. And
// a thread may read a slot only after the thread that stores it has done so: call
// barrier() in between. Every thread of the workgroup must reach the barrier, so it
// must not stand inside a branch.
// [/blur_line]
vec3 blur_line(int start, int radius) {
    return texel(start + int(gl_LocalInvocationIndex));
}
