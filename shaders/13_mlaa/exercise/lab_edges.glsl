// Exercise 13.lab_edges: a pixel is compared with its neighbours, which its neighbours do as well. Ask each once, and share.
// Until you fill it in, nothing has an edge.
#include "13_mlaa/lab_source.glsl"

// [lab_edges]
// All 256 threads of a workgroup call this together, once, with the same `corner`, the first pixel of a square of 16 by 16.
// Thread t, which is int(gl_LocalInvocationIndex), answers for the pixel corner + (t % 16, t / 16): the sum of 1 where
// lab_distance() to the pixel on its right is above the threshold, 2 to the one below, 4 to the one on its left, 8 to the
// one above. y grows downwards. lab_at(pixel) is slow, and knows what to give for pixels outside of the picture: it must be
// asked at most once by the whole workgroup for each pixel of the square and of those that touch it. What it gives is kept
// for all threads by keep_lab(slot, lab) and read by kept_lab(slot); slots are 0 to 18 * 18 - 1. There are more pixels than
// threads. And what must have happened before a thread reads what another has kept?
// [/lab_edges]
uint lab_edges(ivec2 corner, float threshold) {
    return 0u;
}
