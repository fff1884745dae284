// Exercise 13.area: the area between silhouette and line within a pixel.
// Starter: the silhouette follows the borders of the pixels, and nothing is mixed.
#include "13_mlaa/exercises.h"

namespace lightwalk::exercise {

// [area]
// A line of `length` pixels (1 to 509) turns at its start. There the silhouette is half
// a pixel above the line. It descends evenly and meets the line in the middle,
// length / 2 pixels from the start; from there on it coincides with the line.
//
// Returns the exact area between silhouette and line within the pixel number `position`
// (0 is the first, length - 1 the last), within a millionth: 0 to 1/2. If the length is
// odd, the silhouette ends within a pixel. For a line of one pixel the result is 0: it
// is a step of a line in the other direction, where its corner is counted.
// [/area]
float area(int position, int length) {
    (void)position, (void)length;
    return 0.0f;
}

}  // namespace lightwalk::exercise
