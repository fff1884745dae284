// Exercise 09.bayer_dither: more shades than a screen has codes.
// Until you fill it in, every pixel is rounded alike.

// [bayer_dither]
// The threshold of a pixel in B. E. Bayer's ordered dither of 2^bits by 2^bits pixels, bits 1 to 4, which repeats over the picture.
// A code v (say 100.3) becomes floor(v + threshold). With N = 4^bits the thresholds of a square are (0.5 + i) / N for i = 0 to N - 1,
// each once: their mean is 1/2, and the mean of the codes v. High ones lie far apart: for every k from 1 to bits, the 4^k largest
// thresholds lie in 4^k different squares of 2^(bits - k) by 2^(bits - k) pixels. Bayer builds the square from smaller ones:
//     B(0) = [0],   B(n + 1) = [ 4 B(n)      4 B(n) + 2 ]
//                              [ 4 B(n) + 3  4 B(n) + 1 ]
// Turned or mirrored it is as good.
// A shader wants no table: what does each bit of x and of y say about i?
// [/bayer_dither]
float bayer(uvec2 pixel, int bits) {
    return 0.5;
}
