// A pixel's edges below it and on its right: the number of pixels by which the line of edges below continues to the
// left and to the right, and that on the right up and down, the pixel itself counted: four bytes. Valid beside edges
// alone: elsewhere nothing was written.
const uint back_below = 0u, ahead_below = 8u, back_right = 16u, ahead_right = 24u;

// A step of a staircase: the edge below a pixel, and the edge across that goes on downwards from its end, on the right
// ("falling") or on the left ("rising"). For how many steps the staircase goes on, in the bytes of a word: falling back (up
// and left) and ahead (down and right), rising back (up and right) and ahead (down and left).
const uint back_falling = 0u, ahead_falling = 8u, back_rising = 16u, ahead_rising = 24u;

uint byte_of(uint word, uint shift) { return word >> shift & 255u; }
