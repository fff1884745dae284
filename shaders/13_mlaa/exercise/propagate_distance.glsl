// Exercise 13.propagate_distance: how long a line is, in few passes.
// Until you fill it in, every line ends after the next pixel.
#include "13_mlaa/known_distance.glsl"

// [propagate_distance]
// known(steps) says for how many pixels the line goes on beyond the pixel that lies `steps` ahead, as far as the passes
// before have found out: 0 where it ends. known(0) is what is known at this pixel itself. The pixel at which that stretch
// ends knows more, or nothing: what is known there is added, and so on from the new end, until `reads` numbers were read
// (2 or more; known() is a read of an image, and is not called again), or one of them is 0. The result is at most `reach`:
// it must fit into a byte, and nobody may see farther.
// [/propagate_distance]
uint propagate_distance(int reads, uint reach) {
    return min(known(0u), reach);
}
