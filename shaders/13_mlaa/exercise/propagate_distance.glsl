// Exercise 13.propagate_distance: how long an edge is, in few passes.
// Until you fill it in, every edge is one pixel long.
#include "13_mlaa/known_distance.glsl"

// [propagate_distance]
// known(steps) says for how many pixels the edge goes on, from the pixel `steps` ahead and with it, as far as the passes
// before have found out: 0 where there is no edge. known(0) is this pixel's own, 1 or more. Where that stretch ends another
// may begin: what is known there is added, and so on, until `reads` numbers were read (2 or more; known() is a read of an
// image, and is not called again), or one of them is 0. The result is at most `reach`: it must fit into a byte, and nobody
// may see farther.
// [/propagate_distance]
uint propagate_distance(int reads, uint reach) {
    return min(known(0u), reach);
}
