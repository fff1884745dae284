// Exercise 08.choose_blur: choose and defend: reads for three blurs.
// Starter: two lines of single texels, far too few.

// [choose_blur]
// A picture is blurred by a Gaussian. `blur` is one of three, with sigma in pixels:
// - 0: sigma 2;
// - 1: sigma 12;
// - 2: sigma 48.
//
// Returns the method and its radius r in pixels, 0 to 256; weights beyond r are 0, and the others
// add up to 1. Methods, and what they read for a pixel of the picture:
// - 1: a square of (2 r + 1)^2 texels;
// - 2: two passes, along x and along y, of 2 r + 1 texels each;
// - 3: two passes in which a read between two texels fetches both: r + 1 reads each;
// - 4: a quarter of the width and height: 1 read for the smaller picture, two passes in it of
//   2 [r / 4] + 1 texels each, which count a sixteenth, and 1 read between four of its texels for
//   the result. [] rounds down.
//
// Limits: blur 0 may cost 16 reads and err by 0.5%, blur 1 80 reads and 1%, blur 2 12 reads and
// 2.5%. The error is the largest difference between a blurred point and the Gaussian, relative to
// the Gaussian's peak. The check measures both and prints them.
// [/choose_blur]
ivec2 choose_blur(int blur) {
    return ivec2(2, 3);
}
