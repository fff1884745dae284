// Exercise 09.histogram_bin: a histogram of luminance, counted by a workgroup together.
// Starter: all pixels are in bin 0, and each adds itself to the histogram of the picture.
#include "09_post_effects/histogram_source.glsl"

// [histogram_bin]
// histogram_bin: returns the bin, 0 to 255, of a luminance. Bin 0 holds luminances
// below 2^-12, negative ones, and NaN. Bins 1 to 255 divide the 24 stops from 2^-12 to
// 2^12 evenly in the logarithm: bin 1 begins at 2^-12. Bin 255 also holds everything
// brighter, infinity included. (Converting NaN or infinity to an integer is undefined
// in GLSL.)
//
// count_together: all 256 threads of a workgroup call it once, each with the bin of its
// pixel and with `counts`, which is false for a thread without a pixel. Afterwards the
// histogram of the picture has grown, in each bin, by the number of threads that
// counted there.
//
// add_to_picture(bin, n) adds n to a bin of the picture. It is slow, because all
// workgroups wait for each other there: a workgroup may call it at most once per bin,
// and only for bins in which one of its threads counted. Until then the workgroup
// counts in own_bins[256], in shared memory, whose initial content is undefined.
// Several threads may change the same word only with atomicAdd(). Use barrier() so that
// no thread counts before the bins are cleared, or reads before all have counted; every
// thread must reach it.
// [/histogram_bin]
uint histogram_bin(float luminance) {
    return 0u;
}

void count_together(uint bin, bool counts) {
    if (counts) add_to_picture(bin, 1u);
}
