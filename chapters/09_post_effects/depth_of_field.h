// Depth-of-field module.
#pragma once
#include "06_deferred/deferred_scene.h"
#include "09_post_effects/dof_now.h"
#include "common/app/drawing.h"
#include "common/app/world.h"
#include "common/base/epoch.h"

namespace lightwalk {

/// In a frame, instead of draw():
///
///     dof.record(frame, view, canvas, {objects});
///
/// draws once for all methods but `lens`, the truth: that draws the picture from many places of the lens, and takes
/// their mean.
struct DepthOfField : Module {
    DepthOfField(Module& owner, std::string name);

    Choice method{*this,
                  "method",
                  {"off", "gaussian", "gather", "lens"},
                  "off",
                  "Depth of field: none (a pinhole); a blurred picture of half resolution; discs gathered in front and "
                  "behind; the sampled lens (reference)"};
    Knob<float> focus_m{*this, "focus_m", 3.0f, {0.01f, 10000.0f}, "Distance of the plane of focus", "m"};
    Knob<float> f_number{
        *this, "f_number", 2.8f, {0.01f, 64.0f}, "Aperture: focal length divided by the diameter of the lens"};
    Knob<float> sensor_mm{*this, "sensor_mm", 24.0f, {1.0f, 1000.0f}, "Height of the sensor", "mm"};
    Knob<float> most{
        *this, "most", 0.1f, {0.0f, 0.5f}, "Maximum diameter of a disc, as a fraction of the picture height"};
    Knob<int> taps{*this, "taps", 64, {8, 1024}, "Number of reads per disc (method gather)"};
    Knob<int> views{
        *this, "views", 64, {1, 65536}, "Number of sample points on the lens, one picture each (method lens)"};

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
    Fingerprint taps_made_;
    uint32_t tap_count_ = 0;
    Pipeline half_ = compute({.shader = "09_post_effects/dof_half.comp"});
    Pipeline tiles_ = compute({.shader = "09_post_effects/dof_tiles.comp"});
    Pipeline spread_ = compute({.shader = "09_post_effects/dof_spread.comp"});
    Pipeline gather_ = compute({.shader = "09_post_effects/dof_gather.comp"});
    Pipeline fill_ = compute({.shader = "09_post_effects/dof_fill.comp"});
    Pipeline compose_ = compute({.shader = "09_post_effects/dof_compose.comp"});
    Pipeline add_ = compute({.shader = "common/accumulate.comp"});
    Pipeline line_ = compute({.shader = "08_bloom/line.comp"});
};

struct ThroughLens : World {
    explicit ThroughLens(Module& owner) : World(owner) { objects.maps.method.change_default("normal"); }
    DepthOfField dof{*this, "dof"};
    DeferredScene objects{*this, "objects"};

    Drawings drawings() override { return {objects}; }
    glm::vec4 background() const override { return {glm::vec3(World::background()), 0.0f}; }
    std::vector<std::pair<std::string, std::string>> look() const override { return {{"bloom.method", "none"}}; }

  protected:
    void draw_view(Frame& frame, const View& view, Canvas& canvas) override {
        dof.record(frame, view, canvas, drawings());
    }
};

}  // namespace lightwalk
