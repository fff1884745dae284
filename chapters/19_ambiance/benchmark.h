// Benchmark of a film: what a viewer sees, and what each scene costs the GPU.
#pragma once
#include "13_mlaa/mlaa.h"
#include "19_ambiance/reel.h"
#include "common/app/options.h"

namespace lightwalk {

/// Plays the film from its beginning (played.h): all of it, or options.frames frames of each scene if given. Then draws as
/// many frames of each scene (60 unless given), evenly over its time, with and without morphological anti-aliasing in
/// turn. Writes JSON: the device; `in_order`, `scenes` and `cuts` of played_figures(); and as each scene's `gpu_sum` the
/// milliseconds of its passes (min, mean, p99), the median of the processor's, and that of each pass. Returns the exit
/// code. Throws InputError.
int run_benchmark(Chapter& chapter, Reel& reel, Mlaa& antialias, const std::string& file, const Options& options,
                  std::unique_ptr<Gpu>& gpu);

}  // namespace lightwalk
