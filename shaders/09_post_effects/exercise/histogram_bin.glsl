// Exercise 09.histogram_bin: how bright a picture's pixels are, counted by a workgroup together.
// Until you fill it in, all pixels are in the first bin, and each adds itself to the whole picture's count.
#include "09_post_effects/histogram_source.glsl"

// [histogram_bin]
// histogram_bin: which of 256 bins a luminance is counted in. Bin 0 has what is darker than 2^-12, below 0, or NaN. Bins 1 to 255
// share the 24 stops from 2^-12 to 2^12 evenly in the logarithm: bin 1 begins at 2^-12, and bin 255 has all that is brighter too,
// an infinite luminance as well.
//
// count_together: all 256 threads of a workgroup call it once, each with its pixel's bin and whether it has a pixel (`counts`).
// Afterwards the picture's count of each bin must have grown by the threads with that bin; add_to_picture(bin, n) adds n to it. That is
// slow, because all workgroups wait for each other there: a workgroup calls it at most once for each bin, and only for bins that
// somebody counted. Until then it counts in own_bins[256], shared memory, which holds anything when the workgroup begins.
// atomicAdd() is what several threads may do to one word at once.
// [/histogram_bin]
uint histogram_bin(float luminance) {
    return 0u;
}

void count_together(uint bin, bool counts) {
    if (counts) add_to_picture(bin, 1u);
}
