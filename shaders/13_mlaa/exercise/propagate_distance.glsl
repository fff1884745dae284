// Exercise 13.propagate_distance: the length of a line, in few passes.
// Starter: every line ends after the next pixel.
#include "13_mlaa/known_distance.glsl"

// [propagate_distance]
// Returns the length of a line beyond this pixel, as far as it can be known after this
// pass. known(steps) is the number of pixels for which the line continues beyond the
// pixel that lies `steps` ahead, as found by the passes before; 0 means that the line
// ends there. known(0) belongs to this pixel itself.
//
// Start with known(0). The pixel at the end of that stretch knows how the line
// continues: add its number. Repeat from the new end, until `reads` numbers have been
// read (2 or more, known(0) included) or one of them is 0. known() reads an image: do
// not call it more often than that.
//
// The result is at most `reach`, because it must fit into a byte.
// [/propagate_distance]
uint propagate_distance(int reads, uint reach) {
    return min(known(0u), reach);
}
