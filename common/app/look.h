// Shows a pass's output before a later pass overwrites it.
#pragma once
#include "common/gpu/frame.h"
#include "common/scene/camera.h"
#include "common/scene/mesh.h"

namespace lightwalk {

/// A rectangle of an image, and how another one is shown in it.
struct Shown {
    glm::uvec2 corner{0}, size{0};  ///< pixels
    float stops = 0.0f;             ///< brighter by 2^stops
    int channel = 0;                ///< 0 all, 1 to 4 one of red, green, blue, alpha
};

/// A pass that makes any image of a frame visible, fitted into a rectangle of `into`. `camera` and `bounds` (metres) say
/// which depths there are to see.
void show_image(Frame& frame, const std::string& pass, const ImageView& view, const Image& into, const Shown& shown,
                const Camera& camera, const Bounds& bounds);

struct Look {
    std::string output;  ///< one of names(), or a pass, for the first image it writes; empty: the picture itself
    float stops = 0.0f;  ///< brighter by 2^stops
    int channel = 0;     ///< 0 all, 1 to 4 one of red, green, blue, alpha

    /// Outputs of the last recorded frame, in order: "pass: image".
    static std::vector<std::string> names(const Frame& frame);

    /// Makes the frame copy that output, visibly, into `copy` when its pass has been recorded; `copy` is made where it
    /// is none of the frame's size. Call it before recording. `camera` and `bounds` (metres) say which depths there are
    /// to see.
    void attach(Frame& frame, Image& copy, const Camera& camera, const Bounds& bounds) const;

    /// Throws InputError with the available names if the frame lacks the wanted output.
    void check(const Frame& frame) const;

    /// The picture to show for a recorded frame: its output, or the copy of the chosen pass.
    const Image& picture(const Frame& frame, const Image& copy) const;

  private:
    // `view` is a copy: recording adds to the list that it comes from.
    void record(Frame& frame, Image& copy, ImageView view, const Camera& camera, const Bounds& bounds) const;
};

}  // namespace lightwalk
