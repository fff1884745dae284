// Exercise 13.lab_edges: edges between pixels, with each colour read once and shared by the workgroup.
// Starter: there are no edges.
#include "13_mlaa/lab_source.glsl"

// [lab_edges]
// All 256 threads of a workgroup call this function together, once, with the same
// `corner`, the first pixel of a square of 16 by 16. Thread t, which is
// int(gl_LocalInvocationIndex), answers for the pixel corner + (t % 16, t / 16). y
// grows downwards. It returns a sum of bits, one for each neighbour whose
// lab_distance() to the pixel is above the threshold: 1 for the right neighbour, 2 for
// the one below, 4 for the left one, 8 for the one above.
//
// lab_at(pixel) is slow. The whole workgroup may call it at most once for each pixel of
// the square and of the pixels around it; it also accepts pixels outside of the
// picture. keep_lab(slot, lab) stores a colour in shared memory for all threads,
// kept_lab(slot) reads it; slots are 0 to 18 * 18 - 1.
//
// There are more pixels than threads, so some threads load several. A thread may read a
// slot only after the thread that stores it has done so: call barrier() in between,
// outside of any branch.
// [/lab_edges]
uint lab_edges(ivec2 corner, float threshold) {
    return 0u;
}
