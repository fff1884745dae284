// Rendering of a chapter's pictures.
#pragma once
#include <optional>

#include "common/app/chapter.h"
#include "common/image/image.h"

namespace lightwalk {

struct Picture {
    glm::uvec2 size{960, 540};
    float time_s = 0;
    unsigned seed = 0;
    Crop crop;
    std::optional<glm::ivec2> sample{};  ///< {index, count}: a single sub-frame; empty: all, in order
    /// Frames to accumulate from a cold start, 1/60 s apart; 0: continues the last frame; empty: Module::accumulation.
    std::optional<int> gathered{};
    ReadBack* written = nullptr;
};

/// Renders chapter.samples jittered frames and waits. frame.linear() and frame.output receive their mean in linear
/// light; frame.times the sums per pass, or the last frame's times for accumulated pictures.
void render(Chapter& chapter, Frame& frame, const Picture& picture);

/// Renders at time 0 with the current knobs and returns linear light. Blocks. For Chapter::measure().
ImageRgb render_linear(Chapter& chapter, Gpu& gpu, glm::uvec2 size);

void add_times(std::vector<PassTime>& sum, const std::vector<PassTime>& times);

/// Adds frame.hdr to the mean of sub-frames, if there are several.
void accumulate(Frame& frame);

/// Writes linear light to frame.output, clamped and sRGB-encoded, for chapters without a tone curve.
void encode_srgb(Frame& frame);

}  // namespace lightwalk
