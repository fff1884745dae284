// A film played from its beginning, and the times of its frames.
#pragma once
#include "19_ambiance/timeline.h"
#include "common/app/chapter.h"
#include "common/app/options.h"

namespace lightwalk {

// [played]
/// A frame of a film that is played, 1/60 s of the film apart.
struct PlayedFrame {
    int number = 0;           ///< its time is number / 60 s
    double wall_ms = 0;       ///< from the end of the frame before to its own; the first one since the program started
    double processor_ms = 0;  ///< of the thread that records
    double gpu_ms = 0;        ///< sum over its passes
    std::optional<size_t> scene;  ///< the one on the screen, of two the later one
};

/// Numbers of frames in order. `each_scene`: so many of each scene, evenly, besides the film's first second and six after
/// each cut; none: all frames.
std::vector<int> played_numbers(const Timeline& film, std::optional<int> each_scene);

/// Draws them in this order, two frames in flight, as a window would.
std::vector<PlayedFrame> play(Chapter& chapter, Gpu& gpu, const Timeline& film, const Options& options);

/// Times of all frames and of each scene: mean, 99th percentile and longest, the GPU's mean, and the processor's median,
/// in which shaders compiled once do not count. The first frame, and the longest of the first second. At each cut six
/// frames, the longest of them, and the scene's mean.
nlohmann::json played_figures(const Timeline& film, const std::vector<PlayedFrame>& frames);
// [/played]

}  // namespace lightwalk
