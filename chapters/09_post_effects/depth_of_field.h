// What a lens does that a pinhole does not, as a module.
#pragma once
#include "09_post_effects/dof_now.h"
#include "common/app/drawing.h"

namespace lightwalk {

// [dof]
/// In a frame, in place of draw():
///
///     dof.record(frame, view, canvas, {objects});
///
/// draws once for all methods but `lens`, the truth: that draws the picture from many places of the lens, and takes
/// their mean.
struct DepthOfField : Module {
    DepthOfField(Module& owner, std::string name) : Module(owner, std::move(name), "dof") {}

    Choice method{*this,
                  "method",
                  {"off", "gaussian", "gather", "lens"},
                  "off",
                  "off: a pinhole; a blurred half of the picture; discs gathered in front and behind; the lens itself"};
    Knob<float> focus_m{*this, "focus_m", 3.0f, {0.01f, 10000.0f}, "distance of what is sharp", "m"};
    Knob<float> f_number{*this, "f_number", 2.8f, {0.01f, 64.0f}, "focal length over the width of the lens"};
    Knob<float> sensor_mm{*this, "sensor_mm", 24.0f, {1.0f, 1000.0f}, "height of the sensor", "mm"};
    Knob<float> most{*this, "most", 0.1f, {0.0f, 0.5f}, "no disc is wider than this share of the picture's height"};
    Knob<int> taps{*this, "taps", 64, {8, 1024}, "of gather: places read in each disc"};
    Knob<int> views{*this, "views", 64, {1, 65536}, "of lens: places of the lens, each a whole picture"};
    // [/dof]

    void record(Frame& frame, const View& view, Canvas& canvas, const Drawings& drawings);

    /// The camera's focal length, which its field of view and the sensor give, in metres.
    float focal_m(const Camera& camera) const;
    /// The lens's radius that gives the same discs as the formula, in metres.
    float radius_m(const Camera& camera) const;

  private:
    void sample_lens(Frame& frame, const View& view, Canvas& canvas, const Drawings& drawings);
    void set_up(const View& view);
    void gather(Frame& frame);
    void blur(Frame& frame);
    Image& image(Frame& frame, const char* name, VkFormat format, glm::uvec2 size);

    DofNow now_{};
    std::map<std::string, Image> images_;
    Buffer taps_;
    float made_for_px_ = -1;
    uint32_t tap_count_ = 0;
    Pipeline half_ = compute({.shader = "09_post_effects/dof_half.comp"});
    Pipeline tiles_ = compute({.shader = "09_post_effects/dof_tiles.comp"});
    Pipeline spread_ = compute({.shader = "09_post_effects/dof_spread.comp"});
    Pipeline gather_ = compute({.shader = "09_post_effects/dof_gather.comp"});
    Pipeline fill_ = compute({.shader = "09_post_effects/dof_fill.comp"});
    Pipeline compose_ = compute({.shader = "09_post_effects/dof_compose.comp"});
    Pipeline add_ = compute({.shader = "common/accumulate.comp"});
    Pipeline take_ = compute({.shader = "08_bloom/look.comp"});
    Pipeline line_ = compute({.shader = "08_bloom/line.comp"});
};

}  // namespace lightwalk
