// Exercise 08.blur_line: neighbouring pixels of a blur read nearly the same texels. Read each once, and share them.
// Until you fill it in, nothing is blurred.
#include "08_bloom/line_source.glsl"

// [blur_line]
// All 256 threads of a workgroup call this together, with the same `start` and `radius` (0 to 896), once. Thread t, which is
// int(gl_LocalInvocationIndex), returns the sum over k from -radius to radius of weight_at(abs(k)) * texel(start + t + k).
// texel(i) is slow: the workgroup must ask it once, and no more, for each of the 256 + 2 radius texels that its threads
// need together. What it gives is kept for all threads by keep_texel(slot, value) and read by kept_texel(slot), slots 0 to
// 2047, in shared memory. There are more texels than threads: who reads those before the first and after the last? And
// what must have happened before a thread reads what another has kept?
// [/blur_line]
vec3 blur_line(int start, int radius) {
    return texel(start + int(gl_LocalInvocationIndex));
}
