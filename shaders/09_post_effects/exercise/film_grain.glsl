// Exercise 09.film_grain: noise that does not repeat.
// Starter: the film has no grain.

// [film_grain]
// Returns a number from -1 to 1 for a pixel of a frame of the film. The
// numbers are uniformly distributed, hence of mean 0 and variance 1/3. They show no
// pattern: neighbouring pixels, rows, columns, and the same pixel in consecutive frames
// are uncorrelated, and (x, y) and (y, x) differ. The same pixel and frame always give
// the same number.
//
// No part repeats: not after 64 or 1024 pixels, not after 16 frames. And the grain
// stays as good: after eleven and a half days at 24 frames per second, `frame` is
// 24,000,000.
//
// Any good mixing function is right; the check looks only at the numbers. Integers suit
// this task: multiply, shift, exclusive or, repeat. sin() of a large number does not,
// because a large float has lost the digits that matter before the sine is taken.
// [/film_grain]
float film_grain(uvec2 pixel, uint frame) {
    return 0.0;
}
