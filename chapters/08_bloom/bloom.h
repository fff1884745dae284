// Bloom module, for any picture in linear light.
#pragma once
#include "08_bloom/plan.h"
#include "common/app/module.h"
#include "common/base/epoch.h"
#include "common/gpu/frame.h"

namespace lightwalk {

/// Call before tone mapping: bloom.record(frame, frame.hdr); adds the blurred light of the bright parts to the RGBA16F
/// image, of any size. NaN becomes 0, infinity 65504. Alpha stays. A picture without bright parts dispatches no blur.
/// Once per frame and module.
struct Bloom : Module {
    Bloom(Module& owner, std::string name);

    Choice method{*this,
                  "method",
                  {"none", "copy", "pyramid", "dual_kawase", "three_pass_7tap", "shared", "paired", "separable",
                   "pingpong", "window", "exact"},
                  "pyramid",
                  "Blur: none; the copies of a pyramid without its filters; 13-tap pyramid; dual Kawase pyramid; three "
                  "passes of seven taps; lines in shared memory; lines with paired reads; plain lines; twenty passes; "
                  "a double loop; the reference"};
    Knob<float> sigma_px{*this, "sigma_px", 24.0f, {0.0f, 200.0f}, "Standard deviation of the widest Gaussian", "px"};
    Choice shape{*this,
                 "shape",
                 {"gaussian", "sum"},
                 "sum",
                 "Point-spread function: one Gaussian, or a sum of narrow and wide ones"};
    Choice cut{*this,
               "cut",
               {"none", "hard", "soft"},
               "soft",
               "Bright pass: all light, light above a hard threshold, or light above a soft one"};
    Knob<float> threshold{*this, "threshold", 1.0f, {0.0f, 1000.0f}, "Threshold of the bright pass, as a luminance"};
    Knob<float> knee{
        *this, "knee", 0.5f, {0.0f, 1.0f}, "Half width of the soft threshold, as a fraction of the threshold"};
    Choice compose{
        *this,
        "compose",
        {"add", "mix"},
        "add",
        "Composition: add the blurred light, or move light (subtract what was blurred); mix is meant for cut none"};
    Knob<float> strength{
        *this,
        "strength",
        0.6f,
        {0.0f, 10.0f},
        "Fraction of the blurred light that is added; with compose mix, of the light that moves (0 to 1)"};
    Choice border{*this,
                  "border",
                  {"clamp", "mirror", "black"},
                  "mirror",
                  "Light outside of the picture: the nearest border pixel, the picture mirrored, or black"};
    Knob<float> truncation{
        *this, "truncation", 3.0f, {1.0f, 4.0f}, "Radius at which a line blur is truncated, in units of sigma"};
    Knob<bool> karis{
        *this, "karis", false,
        "Karis weights: the pyramid gives bright pixels less weight, which reduces flicker and loses light"};

    void record(Frame& frame, const Image& hdr);

    /// Bright pass and blur of the last frame; the blur is undefined if nothing was bright.
    const Image& cut_out() const { return images_.at(0); }
    const Image& spread() const { return images_.at(1); }

    /// Shows an image of the last frame instead of the picture: bright pass (0), blur (1), levels; beyond the last, the
    /// last one. Black if nothing was bright.
    void show(Frame& frame, size_t image, float gain) const;

    const Plan& plan() const { return plan_; }
    BlurWish wish(glm::uvec2 size) const;

  private:
    void set_up(Frame& frame, glm::uvec2 size);
    void record_blur(Frame& frame);

    Fingerprint plan_made_;
    Plan plan_;
    std::vector<Image> images_;  ///< as in the plan
    Fingerprint groups_made_;
    Fingerprint taps_made_;
    Buffer taps_;      ///< of the plan
    Buffer wanted_;    ///< workgroups of each step, were there something to spread
    Buffer dispatch_;  ///< those, or zeros; after them two words of dispatches.glsl
    const Pipeline& pipeline_of(const Step& step) const;
    Pipeline bright_ = compute({.shader = "08_bloom/bright.comp"});
    Pipeline decide_ = compute({.shader = "08_bloom/decide.comp"});
    Pipeline line_ = compute({.shader = "08_bloom/line.comp"});
    Pipeline full_line_ = compute({.shader = "08_bloom/line.comp", .macros = {{"FULL_FLOATS", "1"}}});
    Pipeline level_line_ = compute({.shader = "08_bloom/line.comp", .macros = {{"OF_A_LEVEL", "1"}}});
    Pipeline shared_ = compute({.shader = "08_bloom/shared.comp"});
    Pipeline window_ = compute({.shader = "08_bloom/window.comp"});
    Pipeline down_ = compute({.shader = "08_bloom/down.comp"});
    Pipeline karis_down_ = compute({.shader = "08_bloom/karis_down.comp"});
    Pipeline up_ = compute({.shader = "08_bloom/up.comp"});
    Pipeline kawase_down_ = compute({.shader = "08_bloom/kawase_down.comp"});
    Pipeline kawase_up_ = compute({.shader = "08_bloom/kawase_up.comp"});
    Pipeline copy_ = compute({.shader = "08_bloom/copy.comp"});
    Pipeline combine_ = compute({.shader = "08_bloom/combine.comp"});
};

}  // namespace lightwalk
