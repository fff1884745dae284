// Inspection of a pass's output before a later pass overwrites it.
#pragma once
#include "common/gpu/frame.h"
#include "common/scene/camera.h"
#include "common/scene/mesh.h"

namespace lightwalk {

struct Shown {
    glm::uvec2 corner{0}, size{0};
    float stops = 0.0f;  ///< exposure: gain 2^stops
    int channel = 0;     ///< 0: all; 1 to 4: red, green, blue, alpha
};

/// Pass that displays any image within a rectangle of `into`. `camera` and `bounds` (metres) set the depth range.
void show_image(Frame& frame, const std::string& pass, const ImageView& view, const Image& into, const Shown& shown,
                const Camera& camera, const Bounds& bounds);

/// Lists an image that a pass of an earlier frame wrote and this frame keeps with this frame's outputs, under that
/// output's name. Between passes.
void list_kept(Frame& frame, const std::string& name, const ImageView& view);

struct Look {
    std::string output;  ///< one of names(), or a pass for its first output; empty: the final picture
    float stops = 0.0f;
    int channel = 0;

    /// Outputs of the last frame, "pass: image", in pass order.
    static std::vector<std::string> names(const Frame& frame);

    /// Makes the frame copy the selected output into `copy` right after its pass. Call before recording.
    void attach(Frame& frame, Image& copy, const Camera& camera, const Bounds& bounds) const;

    /// Throws InputError with the available names if the output does not exist.
    void check(const Frame& frame) const;

    /// Picture of a recorded frame: the copy of the selected output, or frame.output.
    const Image& picture(const Frame& frame, const Image& copy) const;

  private:
    // `view` by value: recording extends the list it comes from.
    void record(Frame& frame, Image& copy, ImageView view, const Camera& camera, const Bounds& bounds) const;
};

}  // namespace lightwalk
