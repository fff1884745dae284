// Temporal anti-aliasing: samples of a pixel gathered over frames.
#pragma once
#include <optional>
#include <utility>

#include "13_mlaa/moving.h"
#include "common/app/target.h"
#include "common/base/epoch.h"
#include "common/scene/view.h"

namespace lightwalk {

// [seen]
/// The scene behind a picture, for methods that follow surfaces from frame to frame.
struct Seen {
    const View& view;              ///< that it was drawn from
    const ImageView& depth;        ///< D32F, reversed: 0 where nothing is
    const Scene* scene = nullptr;  ///< its items may move; null: nothing does
    /// Of the picture; those that are a MovingSurface may move as well. None: whether the picture rests is not known.
    Drawings drawings{};
};
// [/seen]

// [taa]
/// Mixes each frame with the history of the pixel: earlier samples of the same surface. The renderer shifts each
/// frame within a pixel (Module::accumulation); a written picture takes `warm_up` of them from a cold start, so that it
/// depends on its time alone.
struct Taa : Module {
    Taa(Module& owner, std::string name) : Module(owner, std::move(name), "taa") {}

    Knob<int> warm_up{*this, "warm_up", 32, {1, 256}, "Frames drawn from a cold start for a picture that is written"};
    Knob<float> at_rest{
        *this,
        "at_rest",
        32.0f,
        {1.0f, 256.0f},
        "Samples that the history of a pixel at rest is worth at most, while something in the picture moves"};
    Knob<float> in_motion{
        *this, "in_motion", 6.0f, {1.0f, 256.0f}, "Samples that it is worth where it moves by a pixel or more a frame"};
    Choice clipping{
        *this,
        "clipping",
        {"none", "box", "deviation"},
        "deviation",
        "Limits of the history: none; the range of the 3×3 pixels around it in the new frame (box); or within "
        "that range their mean and a multiple of their standard deviation"};
    Knob<float> gamma{*this, "gamma", 1.0f, {0.0f, 8.0f}, "Standard deviations that the history may be off"};
    Knob<bool> reject{*this, "reject", true, "Rejection of the history where something nearer was seen before"};
    Choice resample{*this,
                    "resample",
                    {"bilinear", "catmull_rom"},
                    "catmull_rom",
                    "Filter that reads the history between its pixels: bilinear, or Catmull-Rom in five reads"};
    Choice weights{*this,
                   "weights",
                   {"even", "tone"},
                   "even",
                   "Weights of new light and history: their shares alone, or divided by 1 + luminance (tone), which "
                   "calms bright pixels and darkens edges"};
    Knob<bool> motion{*this, "motion", true, "Motion of objects and water; without it only that of the camera"};

    /// `picture`: RGBA16F, drawn from the view with its shift; gets the picture without it. Once per frame and module.
    void record(Frame& frame, const Image& picture, const Seen& seen);
    Accumulation accumulation() const override;
    bool animated() const override { return true; }
    // [/taa]

  private:
    /// Whether the frame before left a history. Images are made by the first frame that needs them.
    class Remembered : public TargetBase {
      public:
        using TargetBase::TargetBase;
        void begin_frame(Gpu&, glm::uvec2) override { valid = std::exchange(written, false); }
        void forget() override { valid = written = false; }
        bool valid = false, written = false;
    };
    bool set_up(Frame& frame, glm::uvec2 size, const Seen& seen);
    bool is_unchanged(const Frame& frame, const Seen& seen);

    Remembered remembered_{*this};
    Image
        light_[2];  ///< RGBA16F: the history and its samples, below 0 where it moves; of this frame, of the one before
    Image behind_[2];  ///< R32F: 1/m, of the farthest of 3×3 pixels
    Moving moving_;
    std::optional<View> before_;
    Fingerprint unchanged_;
    LightList lights_;
    const Scene* scene_ = nullptr;
    std::filesystem::path scene_file_;  ///< another scene may be loaded at the same address
    Pipeline still_ = compute({.shader = "13_mlaa/taa.comp", .macros = {{"MOVING", "0"}}});
    Pipeline follow_ = compute({.shader = "13_mlaa/taa.comp", .macros = {{"MOVING", "1"}}});
    Pipeline show_ = compute({.shader = "13_mlaa/taa_show.comp"});
};

}  // namespace lightwalk
