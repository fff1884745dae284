// Post-effect module: from linear light to the screen.
#pragma once
#include <glm/glm.hpp>
#include <map>
#include <string>
#include <vector>

#include "09_post_effects/post_now.h"
#include "common/app/target.h"
#include "common/gpu/frame.h"
#include "common/gpu/gpu.h"

namespace lightwalk {

/// From linear Rec. 709 to linear Rec. 709 so that daylight of that correlated colour temperature, 4000 to 25000 K,
/// becomes white: Bradford's adaptation from it to daylight of 6504 K, for which it is the identity.
glm::mat3 white_balance_matrix(double kelvin);

/// Scale factor of light before the tone curve, so that 0.18 has the reference's luminance.
double matching_gain(const std::string& tone);

/// side × side thresholds (0.5 + rank) / side², each once and evenly spread at every level: R. A. Ulichney, "The void-
/// and-cluster method for dither array generation", 1993. side is 4 to 128. The same on every machine.
std::vector<float> blue_noise(int side);

/// side × side numbers of mean 0 and variance 1/3, as white grain has, in clumps of about three pixels, as silver has.
std::vector<float> film_clumps(int side);

/// As a square image of single floats.
Image upload_tile(Gpu& gpu, const std::string& name, const std::vector<float>& tile);

/// Instead of encode_srgb(): encodes 1 - exp(-x) of linear light x in frame.output.
void encode_film(Frame& frame);

/// Automatic exposure. Call record() before stops(): a 1×1 image of four floats with the exposure in stops, its target,
/// and the number of pixels that are not black. Each frame moves the exposure by the share 1 - e^(-dt / adapt_s) of the
/// difference; the first frame, or one without passing time, by all of it.
struct AutoExposure : Module {
    AutoExposure(Module& owner, std::string name);

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

  private:
    History stops_{*this, {.name = "stops", .format = VK_FORMAT_R32G32B32A32_SFLOAT, .size = {1, 1}}};
    const Image* shown_ = nullptr;
    float last_s_ = 0;
    Buffer bins_;
    Pipeline clear_ = compute({.shader = "07_mipmaps/clear_words.comp"});
    Pipeline count_ = compute({.shader = "09_post_effects/histogram.comp"});
    Pipeline adapt_ = compute({.shader = "09_post_effects/adapt.comp"});
};

/// Post effects on a finished frame in linear light: post.record(frame, frame.hdr) maps an RGBA16F image of any size to
/// 0 to 1, still linear. Effects run in the order below; disabled ones are not compiled. Alpha becomes 1. Once per
/// frame and module.
struct Post : Module {
    Post(Module& owner, std::string name);

    Choice method{
        *this,
        "method",
        {"copy", "fused", "pass_each"},
        "fused",
        "Passes: a copy without effects; one pass for all effects that need only their own pixel; one pass per effect"};
    Choice store{*this, "store", {"float", "half"}, "float", "Storage of a channel between passes: 32 bits or 16 bits"};

    // Effects that read other pixels, a pass each.
    Knob<bool> radial_blur{*this, "radial_blur", false, "Radial blur towards one point"};
    Knob<float> blur_by{
        *this, "blur_by", 0.15f, {0.0f, 1.0f}, "Length of the radial blur, as a fraction of the distance to the point"};
    Knob<int> blur_taps{*this, "blur_taps", 4, {1, 64}, "Number of reads of the radial blur"};
    Knob<float> mouse_x{*this,
                        "mouse_x",
                        0.5f,
                        {0.0f, 1.0f},
                        "Horizontal position of the mouse, towards which the radial blur points: 0 left, 1 right"};
    Knob<float> mouse_y{*this, "mouse_y", 0.5f, {0.0f, 1.0f}, "Vertical position of the mouse: 0 top, 1 bottom"};
    Knob<bool> aberration{*this, "aberration", false,
                          "Chromatic aberration: a lens that enlarges each colour differently"};
    Knob<glm::vec3> aberration_shift{
        *this,
        "aberration_shift",
        {0.012f, 0.0f, -0.012f},
        {glm::vec3(-0.2f), glm::vec3(0.2f)},
        "Shift of red, green and blue in the corners, as a fraction of the distance from the middle"};
    Knob<float> aberration_rows{*this,
                                "aberration_rows",
                                0.0f,
                                {0.0f, 0.2f},
                                "Displacement of rows by noise, as a fraction of the picture width"};
    Knob<bool> sharpen{*this, "sharpen", false, "Filter with a kernel of 3 by 3 pixels"};
    Choice kernel{*this,
                  "kernel",
                  {"sharpen", "blur", "edges", "emboss"},
                  "sharpen",
                  "Kernel of the filter: sharpen, blur, edge detection, emboss"};
    Knob<float> sharpen_by{
        *this, "sharpen_by", 0.5f, {0.0f, 4.0f}, "Strength of the kernel; 0 leaves the picture unchanged"};

    // Light.
    Choice exposure{*this,
                    "exposure",
                    {"off", "fixed", "automatic"},
                    "off",
                    "Exposure: none, the value of stops, or a value found from the picture"};
    Knob<float> stops{*this,  "stops", 0.0f, {-16.0f, 16.0f}, "Exposure; with automatic, an offset to the value found",
                      "stops"};
    AutoExposure automatic{*this, "automatic"};
    Knob<bool> white_balance{*this, "white_balance", false,
                             "White balance: adaptation to the light of another daylight"};
    Knob<float> white_k{
        *this, "white_k", 6504.0f, {4000.0f, 25000.0f}, "Colour temperature of the daylight that appears white", "K"};

    // Tone mapping.
    Choice tone{*this,
                "tone",
                {"off", "clamp", "reinhard", "film", "narkowicz", "hill", "neutral", "agx", "aces"},
                "hill",
                "Tone curve from light to display values: none, clamp, Reinhard, film (1 - exp(-x)), Narkowicz, "
                "Hill, Khronos Neutral, AgX, ACES 1.0 (the reference that Narkowicz and Hill approximate)"};
    Knob<bool> match{*this, "match", false,
                     "Equal brightness: every tone curve maps middle grey, 0.18, to the value that ACES gives it"};

    // The picture on the screen.
    Knob<bool> contrast{*this, "contrast", false, "Contrast around middle grey"};
    Knob<float> contrast_by{*this, "contrast_by", 1.2f, {0.0f, 4.0f}, "Exponent of the contrast; 1 changes nothing"};
    Knob<bool> brightness{*this, "brightness", false, "Brightness: the same light added everywhere"};
    Knob<float> brightness_by{
        *this, "brightness_by", 0.02f, {-1.0f, 1.0f}, "Light added by brightness, in linear light"};
    Knob<bool> saturation{*this, "saturation", false, "Saturation: distance of colours from grey"};
    Knob<float> saturation_by{
        *this, "saturation_by", 1.2f, {0.0f, 4.0f}, "Factor of the saturation; 1 changes nothing"};
    Knob<bool> greyscale{*this, "greyscale", false, "Greyscale: luminance without colour"};
    Knob<float> greyscale_by{*this, "greyscale_by", 1.0f, {0.0f, 1.0f}, "Strength of the greyscale effect"};
    Knob<bool> invert{*this, "invert", false, "Inversion: a negative"};
    Knob<float> invert_by{*this, "invert_by", 1.0f, {0.0f, 1.0f}, "Strength of the inversion"};
    Knob<bool> vignette{*this, "vignette", false, "Vignette: darker corners"};
    Knob<float> vignette_strength{
        *this, "vignette_strength", 0.5f, {0.0f, 1.0f}, "Darkening of the corners; 1 is black"};
    Knob<float> vignette_power{*this,
                               "vignette_power",
                               2.5f,
                               {0.0f, 8.0f},
                               "Exponent of the vignette; larger values begin nearer to the corners"};
    Knob<bool> scanlines{*this, "scanlines", false, "Scan lines of an old screen"};
    Knob<float> scan_strength{*this, "scan_strength", 0.4f, {0.0f, 1.0f}, "Darkening between scan lines; 1 is black"};
    Knob<float> scan_lines{*this,  "scan_lines", 180.0f, {1.0f, 2000.0f}, "Number of scan lines over the picture",
                           "lines"};
    Knob<float> scan_speed{*this,    "scan_speed", 0.0f, {-100.0f, 100.0f}, "Speed of the scan lines, downwards",
                           "lines/s"};
    Knob<bool> fade{*this, "fade", false, "Fade to one colour"};
    Knob<glm::vec3> fade_color{*this,
                               "fade_color",
                               glm::vec3(0.0f),
                               {glm::vec3(0.0f), glm::vec3(1.0f)},
                               "Colour of the fade, in linear light"};
    Knob<float> fade_by{*this, "fade_by", 0.5f, {0.0f, 1.0f}, "Strength of the fade; 1 shows only the colour"};
    Knob<bool> gamma{*this, "gamma", false, "Gamma: a power of the display values"};
    Knob<float> gamma_by{*this, "gamma_by", 1.0f, {-1.0f, 8.0f}, "Gamma; above 1 brightens, 0 and less change nothing"};

    // On codes.
    Choice grain{*this,
                 "grain",
                 {"off", "white", "texture"},
                 "off",
                 "Film grain: none, independent noise for each pixel, or a tile of clumps"};
    Knob<float> grain_by{
        *this, "grain_by", 0.06f, {0.0f, 0.25f}, "Amplitude of the grain, as a fraction of the full range of codes"};
    Choice dither{*this,
                  "dither",
                  {"off", "bayer_4", "bayer_8", "blue_noise"},
                  "off",
                  "Dither: none, Bayer matrix of 4 by 4 or 8 by 8 pixels, or blue noise"};
    Knob<int> codes{*this, "codes", 256, {2, 256}, "Number of codes per channel for dither"};

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
    std::map<uint64_t, Macros> variants_;  ///< of the shaders, by the effects of a pass
    void set_up(Frame& frame, glm::uvec2 size, size_t images);
    PostNow now(const Frame& frame) const;

    std::vector<Image> between_;  ///< by turns
    Image blue_noise_, grain_tile_;
    Pipeline stack_ = compute({.shader = "09_post_effects/stack.comp"});
    Pipeline gather_ = compute({.shader = "09_post_effects/gather.comp"});
};

}  // namespace lightwalk
