// What happens to a picture between linear light and the screen, as a module.
#pragma once
#include "09_post_effects/auto_exposure.h"
#include "09_post_effects/post_now.h"

namespace lightwalk {

// [post]
/// In a frame, when the picture is finished in linear light:
///
///     post.record(frame, frame.hdr);
///
/// turns the RGBA16F image, of any size, into what a screen shows, 0 to 1 and still linear. Effects happen in the order
/// in which they stand here; what is off is not compiled. Alpha becomes 1. Once per frame and module.
struct Post : Module {
    Post(Module& owner, std::string name) : Module(owner, std::move(name), "post") {}

    Choice method{*this,
                  "method",
                  {"copy", "fused", "pass_each"},
                  "fused",
                  "one pass for all effects that need nothing but their pixel, or one for each; copy: none of them"};
    // [/post]
    Choice store{
        *this, "store", {"float", "half"}, "float", "what is kept of a channel between passes: 32 bits, or 16"};

    // Those that look at other pixels, each a pass of its own.
    Knob<bool> radial_blur{*this, "radial_blur", false, "the rush towards one point"};
    Knob<float> blur_by{*this, "blur_by", 0.15f, {0.0f, 1.0f}, "how far, as a share of the way to that point"};
    Knob<int> blur_taps{*this, "blur_taps", 4, {1, 64}, "how often the picture is read on the way"};
    Knob<float> mouse_x{*this, "mouse_x", 0.5f, {0.0f, 1.0f}, "where that point is, from the left; the mouse's place"};
    Knob<float> mouse_y{*this, "mouse_y", 0.5f, {0.0f, 1.0f}, "and from above"};
    Knob<bool> aberration{*this, "aberration", false, "a lens that enlarges each colour otherwise"};
    Knob<glm::vec3> aberration_shift{
        *this,
        "aberration_shift",
        {0.012f, 0.0f, -0.012f},
        {glm::vec3(-0.2f), glm::vec3(0.2f)},
        "by how much red, green and blue are moved in the corners, shares of the way there"};
    Knob<float> aberration_rows{
        *this, "aberration_rows", 0.0f, {0.0f, 0.2f}, "how far rows are torn apart by noise, shares of the width"};
    Knob<bool> sharpen{*this, "sharpen", false, "a kernel of 3 by 3"};
    Choice kernel{*this, "kernel", {"sharpen", "blur", "edges", "emboss"}, "sharpen", "which"};
    Knob<float> sharpen_by{*this, "sharpen_by", 0.5f, {0.0f, 4.0f}, "how much of it; 0 is the picture as it was"};

    // Light.
    Choice exposure{*this, "exposure", {"off", "fixed", "automatic"}, "off", "by the knob, or by the picture"};
    Knob<float> stops{*this, "stops", 0.0f, {-16.0f, 16.0f}, "of exposure, on top of what automatic finds", "stops"};
    AutoExposure automatic{*this, "automatic"};
    Knob<bool> white_balance{*this, "white_balance", false, "as if white were the light of another lamp"};
    Knob<float> white_k{*this, "white_k", 6504.0f, {4000.0f, 25000.0f}, "daylight that becomes white", "K"};

    // From light to what a screen shows.
    Choice tone{*this,
                "tone",
                {"off", "clamp", "reinhard", "narkowicz", "hill", "neutral", "agx", "aces"},
                "hill",
                "how light becomes a screen's 0 to 1; aces is the reference that narkowicz and hill approximate"};
    Knob<bool> match{*this, "match", false, "every curve shows middle grey, 0.18, as bright as aces does"};

    // The picture on the screen.
    Knob<bool> contrast{*this, "contrast", false, "how far brightnesses are apart"};
    Knob<float> contrast_by{*this, "contrast_by", 1.2f, {0.0f, 4.0f}, "as a power; 1 changes nothing"};
    Knob<bool> brightness{*this, "brightness", false, "the same light on top of everything"};
    Knob<float> brightness_by{*this, "brightness_by", 0.02f, {-1.0f, 1.0f}, "how much"};
    Knob<bool> saturation{*this, "saturation", false, "how far colours are from grey"};
    Knob<float> saturation_by{*this, "saturation_by", 1.2f, {0.0f, 4.0f}, "as a factor; 1 changes nothing"};
    Knob<bool> greyscale{*this, "greyscale", false, "luminance alone"};
    Knob<float> greyscale_by{*this, "greyscale_by", 1.0f, {0.0f, 1.0f}, "how much of it"};
    Knob<bool> invert{*this, "invert", false, "a negative"};
    Knob<float> invert_by{*this, "invert_by", 1.0f, {0.0f, 1.0f}, "how much of it"};
    Knob<bool> vignette{*this, "vignette", false, "darker corners"};
    Knob<float> vignette_strength{*this, "vignette_strength", 0.5f, {0.0f, 1.0f}, "how dark the corners are"};
    Knob<float> vignette_power{*this, "vignette_power", 2.5f, {0.0f, 8.0f}, "how late it begins"};
    Knob<bool> scanlines{*this, "scanlines", false, "the rows of an old screen"};
    Knob<float> scan_strength{*this, "scan_strength", 0.4f, {0.0f, 1.0f}, "how dark it is between them"};
    Knob<float> scan_lines{*this, "scan_lines", 180.0f, {1.0f, 2000.0f}, "how many", "lines"};
    Knob<float> scan_speed{*this, "scan_speed", 0.0f, {-100.0f, 100.0f}, "how fast they run down", "lines/s"};
    Knob<bool> fade{*this, "fade", false, "to one colour"};
    Knob<glm::vec3> fade_color{*this, "fade_color", glm::vec3(0.0f), {glm::vec3(0.0f), glm::vec3(1.0f)}, "which"};
    Knob<float> fade_by{*this, "fade_by", 0.5f, {0.0f, 1.0f}, "how much of it"};
    Knob<bool> gamma{*this, "gamma", false, "a power of what is shown"};
    Knob<float> gamma_by{*this, "gamma_by", 1.0f, {-1.0f, 8.0f}, "above 1 brightens; 0 and less do nothing"};

    // On codes.
    Choice grain{
        *this, "grain", {"off", "white", "texture"}, "off", "film's: a number for each pixel, or a tile of clumps"};
    Knob<float> grain_by{*this, "grain_by", 0.06f, {0.0f, 0.25f}, "how much, of a whole scale of codes"};
    Choice dither{*this,
                  "dither",
                  {"off", "bayer_4", "bayer_8", "blue_noise"},
                  "off",
                  "how what lies between two codes is spread over the two"};
    Knob<int> codes{*this, "codes", 256, {2, 256}, "of dither: how many codes a channel has"};

    void record(Frame& frame, const Image& picture);

    /// Their switches, in the order in which they happen; the first three look at other pixels.
    std::vector<KnobBase*> effects();
    static bool is_on(const KnobBase& effect) { return effect.text() != "off"; }

    bool animated() const override { return !grain.is("off") || aberration_rows > 0 || (scanlines && scan_speed != 0); }

    void bind(Pass& pass) const override;
    std::vector<Resource> reads() const override;

  private:
    using Step = std::vector<KnobBase*>;  ///< the effects of one pass
    std::vector<Step> steps();
    void run(Frame& frame, const Step& step, const Image& from, const Image& into);
    void set_up(Frame& frame, glm::uvec2 size, size_t images);
    PostNow now(const Frame& frame) const;

    std::vector<Image> between_;  ///< by turns
    Image blue_noise_, grain_tile_;
    Pipeline stack_ = compute({.shader = "09_post_effects/stack.comp"});
    Pipeline gather_ = compute({.shader = "09_post_effects/gather.comp"});
};

}  // namespace lightwalk
