// Exercise 09.film_grain: noise that never repeats.
// Until you fill it in, the film has no grain.

// [film_grain]
// A number from -1 to 1 (1 excluded) for each pixel of each frame of the film: evenly distributed, so that its mean is 0 and
// its variance 1/3, and without anything to see in it: pixels beside each other, one pixel in frames that follow each other,
// and rows and columns as a whole have nothing to do with each other. The same pixel and frame always give the same number.
// `frame` goes on for as long as the program runs: after eleven and a half days at 24 a second it is 24,000,000, and the
// grain must be as good as on the first day.
//
// Whole numbers are good at this: multiply, shift, exclusive or, again. Sines are not: the sine of a large number has lost its
// digits before it is taken.
// [/film_grain]
float film_grain(uvec2 pixel, uint frame) {
    return 0.0;
}
