// Half-plane of black and white, in which the light of every pixel is known exactly.
#pragma once
#include "common/app/drawing.h"

namespace lightwalk {

struct HalfPlane : Drawing {
    HalfPlane(Module& owner, std::string name) : Drawing(owner, std::move(name), "half_plane") {}
    Knob<float> angle_deg{
        *this, "angle_deg", 8.0f, {-360.0f, 360.0f}, "Angle of the line, counter-clockwise from the right", "deg"};
    Knob<float> offset{
        *this, "offset", 0.0f, {-4096.0f, 4096.0f}, "Distance of the line from the middle of the picture", "px"};

    /// Every pixel, with one sample.
    void draw(Frame& frame, const View& view, Canvas& canvas) override;

  private:
    Pipeline fill_ = compute({.shader = "13_mlaa/half_plane.comp"});
};

}  // namespace lightwalk
