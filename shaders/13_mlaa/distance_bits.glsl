// What a pixel holds of the edges below it and on its right: for how many pixels the line of edges below goes on to the left and
// to the right, and that on the right up and down, the pixel itself counted: four bytes. Valid beside edges alone: elsewhere
// nothing was written.
const uint back_below = 0u, ahead_below = 8u, back_right = 16u, ahead_right = 24u;
uint byte_of(uint word, uint shift) { return word >> shift & 255u; }
