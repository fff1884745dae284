// Exercise 13.area: how much of a pixel lies beyond the outline.
// As it stands the outline runs on the pixels' borders, and nothing is mixed.
#include "13_mlaa/exercises.h"

namespace lightwalk::exercise {

// [area]
// A line of `length` pixels (1 to 509), at whose start the outline turns. There the outline really stands half a pixel
// above the line; it falls evenly and meets the line in the middle, length / 2 pixels on, from where on it lies on it.
// Returns the area between outline and line within pixel number `position` (0 is the first; 0 to length - 1) exactly,
// within a millionth: 0 to 1/2. Where the length is odd the outline ends within a pixel. A line of one pixel gives 0:
// it is a step of a line that runs the other way, and its corner is counted there.
// [/area]
float area(int position, int length) {
    (void)position, (void)length;
    return 0.0f;
}

}  // namespace lightwalk::exercise
