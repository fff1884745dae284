// A picture whose every pixel's light is known exactly: black, and white beyond a line.
#pragma once
#include "common/app/drawing.h"

namespace lightwalk {

struct HalfPlane : Drawing {
    HalfPlane(Module& owner, std::string name) : Drawing(owner, std::move(name), "half_plane") {}
    Knob<float> angle_deg{*this, "angle_deg", 8.0f, {-360.0f, 360.0f}, "how steep the line is, from the right up",
                          "deg"};
    Knob<float> offset{*this, "offset", 0.0f, {-4096.0f, 4096.0f}, "how far it passes from the picture's middle", "px"};

    /// Every pixel, with one sample.
    void draw(Frame& frame, const View& view, Canvas& canvas) override;

  private:
    Pipeline fill_ = compute({.shader = "13_mlaa/half_plane.comp"});
};

}  // namespace lightwalk
