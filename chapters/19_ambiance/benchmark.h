// Benchmark of a film: each scene's cost, and hitches at cuts.
#pragma once
#include "13_mlaa/mlaa.h"
#include "19_ambiance/reel.h"
#include "common/app/options.h"

namespace lightwalk {

/// Draws options.frames frames (60 unless given) of each scene, evenly over its time, with and without morphological
/// anti-aliasing in turn, and the frames around each cut in order. Writes JSON: the device; of each scene GPU milliseconds
/// of a frame (min, mean, p99), processor milliseconds, and the median of each pass; of each cut the
/// milliseconds of the frames after it, their longest and their mean. Returns the exit code. Throws InputError.
int run_benchmark(Chapter& chapter, Reel& reel, Mlaa& antialias, const std::string& file, const Options& options,
                  std::unique_ptr<Gpu>& gpu);

}  // namespace lightwalk
