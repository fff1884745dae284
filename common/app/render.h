// Drawing a chapter's frames.
#pragma once
#include <optional>

#include "common/app/chapter.h"
#include "common/image/image.h"

namespace lightwalk {

/// Size, time and sub-pixel shift of a drawn picture.
struct Picture {
    glm::uvec2 size{960, 540};  ///< pixels
    float time_s = 0;
    unsigned seed = 0;
    Crop crop;
    std::optional<glm::ivec2> sample{};  ///< only this one of so many, after those before it; without it all, in order
    /// Where a picture is gathered over frames: from a cold start and so many of them, 1/60 s apart; 0: it goes on from
    /// the frame before; without it as many as Module::gathering says. Then it depends on nothing drawn before.
    std::optional<int> gathered{};
    ReadBack* written = nullptr;  ///< also read back, with the picture's last frame
};

// [render]
/// Records, submits and awaits chapter.samples frames, each shifted within a pixel. frame.linear() and frame.output
/// then hold their mean in linear light, frame.times the sums per pass: of a picture gathered over frames, those of its
/// last frame. If recording throws, the part recorded is still submitted.
void render(Chapter& chapter, Frame& frame, const Picture& picture);
// [/render]

/// Linear light of one more picture with the knobs as they are, at time 0, in a frame of its own: for measure(). Waits.
ImageRgb render_linear(Chapter& chapter, Gpu& gpu, glm::uvec2 size);

/// Adds times to those of passes with the same name.
void add_times(std::vector<PassTime>& sum, const std::vector<PassTime>& times);

/// Adds frame.hdr to the mean of linear light over the pictures so far, where there is more than one.
void accumulate(Frame& frame);

/// Linear light to frame.output: clamped to 1 and sRGB-encoded. Chapters that map tones better do so themselves, after
/// accumulate(frame), from frame.linear().
void encode_srgb(Frame& frame);

}  // namespace lightwalk
