// Looks at what a pass wrote, before a later pass overwrites it.
#pragma once
#include "common/gpu/frame.h"
#include "common/scene/camera.h"
#include "common/scene/mesh.h"

namespace lightwalk {

struct Look {
    std::string output;  ///< one of names(), or a pass, for the first image it writes; empty: the picture itself
    float stops = 0.0f;  ///< brighter by 2^stops
    int channel = 0;     ///< 0 all, 1 to 4 one of red, green, blue, alpha

    /// What can be looked at in the frame that was recorded last, in order: "pass: image".
    static std::vector<std::string> names(const Frame& frame);

    /// Makes the frame copy that output, visibly, into `copy` when its pass has been recorded; `copy` is made where it
    /// is none of the frame's size. Call it before recording. `camera` and `bounds` (metres) say which depths there are
    /// to see.
    void attach(Frame& frame, Image& copy, const Camera& camera, const Bounds& bounds) const;

    /// Throws InputError, which names what there is, where the frame has not recorded what is looked at.
    void check(const Frame& frame) const;

    /// The picture to show of a recorded frame: its output, or the copy of what is looked at.
    const Image& picture(const Frame& frame, const Image& copy) const;

  private:
    // `view` is a copy: recording adds to the list that it comes from.
    void record(Frame& frame, Image& copy, ImageView view, const Camera& camera, const Bounds& bounds) const;
};

}  // namespace lightwalk
