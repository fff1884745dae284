// Automatic exposure from a histogram of luminance, computed on the GPU.
#pragma once
#include "common/app/target.h"
#include "common/gpu/frame.h"

namespace lightwalk {

// [auto_exposure]
/// Automatic exposure. Call record() before stops(): a 1×1 image of four floats with the exposure in stops, its target,
/// and the number of pixels that are not black. Each frame moves the exposure by the share 1 - e^(-dt / adapt_s) of the
/// difference; the first frame, or one without passing time, by all of it.
struct AutoExposure : Module {
    AutoExposure(Module& owner, std::string name) : Module(owner, std::move(name), "auto_exposure") {}

    Knob<float> key{
        *this, "key", 0.18f, {0.01f, 1.0f}, "Target of the mean log luminance after exposure, in linear light"};
    Knob<float> darkest{*this, "darkest", 0.4f, {0.0f, 1.0f}, "Fraction of pixels discarded as too dark"};
    Knob<float> brightest{*this, "brightest", 0.05f, {0.0f, 1.0f}, "Fraction of pixels discarded as too bright"};
    Knob<float> adapt_s{
        *this, "adapt_s", 0.5f, {0.0f, 60.0f}, "Adaptation time: 63% of a change is followed after this time", "s"};
    Knob<float> least_stops{*this, "least_stops", -8.0f, {-16.0f, 16.0f}, "Lower limit of the exposure", "stops"};
    Knob<float> most_stops{*this, "most_stops", 8.0f, {-16.0f, 16.0f}, "Upper limit of the exposure", "stops"};

    void record(Frame& frame, const Image& hdr);
    const Image& stops() const { return *shown_; }
    const Buffer& bins() const { return bins_; }
    // [/auto_exposure]

  private:
    History stops_{*this, {.name = "stops", .format = VK_FORMAT_R32G32B32A32_SFLOAT, .size = {1, 1}}};
    const Image* shown_ = nullptr;
    float last_s_ = 0;
    Buffer bins_;
    Pipeline clear_ = compute({.shader = "07_mipmaps/clear_words.comp"});
    Pipeline count_ = compute({.shader = "09_post_effects/histogram.comp"});
    Pipeline adapt_ = compute({.shader = "09_post_effects/adapt.comp"});
};

}  // namespace lightwalk
