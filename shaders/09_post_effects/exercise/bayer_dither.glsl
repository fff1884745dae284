// Exercise 09.bayer_dither: more shades than a screen has codes.
// Starter: every pixel is rounded in the same way.

// [bayer_dither]
// Returns the threshold of a pixel in B. E. Bayer's ordered dither of 2^bits by 2^bits
// pixels, which repeats over the picture; bits is 1 to 4. A code v (say 100.3) will
// become floor(v + threshold).
//
// Let N = 4^bits. Each pixel of the square has a rank i from 0 to N - 1, each rank
// occurs once, and the threshold is (0.5 + i) / N. So the mean threshold is 1/2, and
// the mean of the resulting codes is v. Pixels of similar rank are far apart: for every
// k from 1 to bits, the 4^k largest thresholds lie in 4^k different squares of
// 2^(bits - k) by 2^(bits - k) pixels. Bayer's matrix of ranks is built recursively:
//
//     B(0) = [0],   B(n + 1) = [ 4 B(n)      4 B(n) + 2 ]
//                              [ 4 B(n) + 3  4 B(n) + 1 ]
//
// A rotated or mirrored matrix is right as well. Do without a table: find what each bit
// of x and y contributes to the rank i.
// [/bayer_dither]
float bayer(uvec2 pixel, int bits) {
    return 0.5;
}
