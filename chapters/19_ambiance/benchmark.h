// Benchmark of a film: what a viewer sees, and what each scene costs the GPU.
#pragma once
#include "13_mlaa/mlaa.h"
#include "19_ambiance/reel.h"
#include "common/app/chapter.h"
#include "common/app/options.h"

namespace lightwalk {

/// A frame of a film that is played, 1/60 s of the film apart.
struct PlayedFrame {
    int number = 0;      ///< its time is number / 60 s
    double wall_ms = 0;  ///< between the ends of the frame before and its own on the device; the first one since the
                         ///< program started
    double processor_ms = 0;                                 ///< of the thread that records
    double gpu_ms = 0;                                       ///< sum over its passes
    uint64_t pipelines = 0, allocations = 0, transfers = 0;  ///< GpuWork
    std::optional<size_t> scene;                             ///< the one on the screen, of two the later one
};

/// Numbers of frames in order. `each_scene`: so many of each scene, evenly, besides the film's first second and six after
/// each cut; none: all frames.
std::vector<int> played_numbers(const Timeline& film, std::optional<int> each_scene);

struct Played {
    std::vector<PlayedFrame> frames;
    double stood_s = 0;  ///< time in which the film would have been ahead of a viewer's clock
};

/// Draws them in this order, two frames in flight, as a window would. A viewer's film is never ahead of its clock: where a
/// scene is not ready, frames pause until it is or until its time has come.
Played play(Chapter& chapter, Reel& reel, Gpu& gpu, const Options& options);

/// Times of all frames and of each scene: mean, 99th percentile and longest, the GPU's mean, and the processor's median,
/// in which shaders compiled once do not count. The first frame, and the longest of the first second. At each cut six
/// frames, the longest of them, the scene's mean, and `steady_ms`, the median of its first second's other frames.
nlohmann::json played_figures(const Timeline& film, const std::vector<PlayedFrame>& frames);

/// Plays the film from its beginning: all of it, or options.frames frames of each scene if given. Then draws as
/// many frames of each scene (60 unless given), evenly over its time, with and without morphological anti-aliasing in
/// turn. Writes JSON: the device; `in_order`, `scenes` and `cuts` of played_figures(); and as each scene's `gpu_sum` the
/// milliseconds of its passes (min, mean, p99), the median of the processor's, and that of each pass. Returns the exit
/// code. Throws InputError.
int run_benchmark(Chapter& chapter, Reel& reel, Mlaa& antialias, const std::string& file, const Options& options,
                  std::unique_ptr<Gpu>& gpu);

}  // namespace lightwalk
