// Exercise 09.film_grain: noise that never repeats.
// Until you fill it in, the film has no grain.

// [film_grain]
// A number from -1 to 1 (1 excluded) for each pixel of each frame of the film: evenly distributed, with mean 0 and variance 1/3, and
// nothing to see in it: neighbours, the same pixel in the next frame, rows and columns have nothing to do with each other. The
// same pixel and frame always give the same number. After eleven and a half days at 24 a second `frame` is 24,000,000, and the grain
// must be as good as on the first day. No tile of it comes again, be it 64 pixels wide or 1,024, nor does a frame after 16. Whatever
// mixes so well is right: the check looks at the numbers, and not at whose they are.
//
// Whole numbers are good at this: multiply, shift, exclusive or, again. The sine of a large number has lost its digits before it
// is taken.
// [/film_grain]
float film_grain(uvec2 pixel, uint frame) {
    return 0.0;
}
