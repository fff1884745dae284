// Ambient occlusion of what is seen, as a module.
#pragma once
#include "common/app/module.h"
#include "common/scene/view.h"

namespace lightwalk {

// [screen_occlusion]
/// Gives shaders screen_occlusion() of 14_environment/screen_occlusion.glsl: of each pixel the share of directions, by
/// their cosine, in which the depth buffer shows nothing within `radius_m`, and their mean direction. record() once a
/// view, when its depth is there and before its surfaces are shaded. (J. Jimenez et al., "Practical real-time strategies
/// for accurate indirect occlusion", SIGGRAPH course, 2016.)
struct ScreenOcclusion : Module {
    ScreenOcclusion(Module& owner, std::string name) : Module(owner, std::move(name), "screen_occlusion") {}

    Knob<float> radius_m{*this, "radius_m", 1.0f, {0.01f, 100.0f}, "Distance within which surfaces hide light", "m"};
    Knob<int> slices{*this, "slices", 3, {1, 64}, "Planes through the line of sight in which horizons are sought"};
    Knob<int> steps{*this, "steps", 8, {1, 64}, "Depths that are read to each side of a slice"};
    Knob<float> thickness{
        *this,
        "thickness",
        0.1f,
        {0.0f, 1.0f},
        "Thinness of objects: share of the way that a horizon falls again over one radius behind what raised it"};
    Choice resolution{
        *this, "resolution", {"half", "full"}, "half", "Pixels in which horizons are sought: one of four, or each"};
    Choice specular{
        *this,
        "specular",
        {"visibility", "cone"},
        "cone",
        "Occlusion of reflections: the visibility as for diffuse light, or the part of the lobe inside of the "
        "cone around the bent normal"};

    void record(Frame& frame, const View& view, const ImageView& depth);
    const Image& image() const { return wide_; }
    std::vector<Resource> reads() const override;
    void bind(Pass& pass) const override;
    // [/screen_occlusion]

  private:
    Image found_, wide_;  ///< RGBA16F: bent normal less normal, world space; visibility. As found, per pixel
    Pipeline seek_ = compute({.shader = "14_environment/screen_occlusion.comp"});
    Pipeline widen_ = compute({.shader = "14_environment/widen_occlusion.comp"});
};

}  // namespace lightwalk
