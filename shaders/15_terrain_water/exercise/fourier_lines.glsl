// Exercise 15.fourier_lines: the sum of 256 waves at 256 points, by butterflies.
// Starter: nothing is added up, and the sea is flat.
#include "15_terrain_water/ocean_line.glsl"

// [fourier_lines]
// `line`, in shared memory, has four lines of 256 texels: line[256 * i + k] is texel k of line i,
// and holds two complex numbers, h_k in xy and g_k in zw. Replaces texel n of each line by two
// sums over k from 0 to 255, of h_k e^(2 pi i k n / 256) and of g_k e^(2 pi i k n / 256).
//
// A workgroup of 256 threads calls this together; `thread` is 0 to 255. What a thread writes to
// shared memory is visible to the others only after a barrier(). That holds for what was written
// before the call as well, and on return every thread may read all of `line`. All threads must
// reach each barrier.
//
// turned(two, by), with a uint `by` from 0 to 127, returns both complex numbers of `two` times
// e^(2 pi i by / 256). A thread may call it at most 16 times: enough for eight steps of
// butterflies, in each of which it takes two pairs. Tolerance: 1e-3.
// [/fourier_lines]
void fourier_lines(uint thread) {
    barrier();
    for (uint i = thread; i < 1024u; i += 256u) line[i] = vec4(0.0);
    barrier();
}
