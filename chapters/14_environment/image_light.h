// Image-based light as a module: an environment as a cube, and its filtered forms for diffuse and glossy surfaces.
#pragma once
#include <array>

#include "07_mipmaps/mip_chain.h"
#include "14_environment/exercises.h"
#include "14_environment/image_light_data.h"
#include "common/app/environment.h"
#include "common/app/module.h"
#include "common/app/target.h"
#include "common/base/epoch.h"
#include "common/image/image.h"
#include "common/scene/scene.h"

namespace lightwalk {

/// How the prefiltered cube is made.
struct Prefilter : Module {
    Prefilter(Module& owner, std::string name);
    Knob<int> samples{*this, "samples", 64, {1, 4096}, "Samples of each texel of the prefiltered cube"};
    Knob<float> bias{*this,   "bias", 1.0f, {0.0f, 8.0f}, "Added to the level that each sample of a texel is read from",
                     "levels"};
};

/// One set of surroundings: radiance, and images derived from it.
struct LightCubes : Module {
    static constexpr uint32_t face_texels = 256;
    using Module::Module;

    /// All levels; box-filtered from the first one on.
    Target radiance{
        *this,
        {.name = "radiance", .size = {face_texels, face_texels}, .mips = 0, .layers = 6, .cube = true, .kept = true}};
    /// By roughness, evenly from 0 in the first level to 1 in the last.
    Target prefiltered{*this,
                       {.name = "prefiltered",
                        .size = {face_texels, face_texels},
                        .mips = 7,
                        .layers = 6,
                        .cube = true,
                        .kept = true}};
    Target irradiance{*this, {.name = "irradiance", .size = {16, 16}, .layers = 6, .cube = true, .kept = true}};
    Buffer sh;  ///< nine coefficients of radiance, windowed, as vec4
};

/// Gives shaders diffuse_light() and reflected_from_around() of 14_environment/image_light.glsl. In each frame, before the
/// first pass that states it in `.with`:
///
///     light.record(frame, scene);   // from the scene's picture, or its ambient light where it has none
///
/// or, for surroundings that were drawn into the first level of light.drawn.radiance:
///
///     light.record_drawn(frame, box);
struct ImageLight : Module {
    ImageLight(Module& owner, std::string name);

    Choice diffuse{*this,
                   "diffuse",
                   {"constant", "sh9", "irradiance"},
                   "irradiance",
                   "Diffuse environment light: its mean, nine spherical-harmonic coefficients, or an irradiance cube"};
    Choice method{*this,
                  "method",
                  {"none", "mirror", "box_mips", "prefiltered", "dominant", "multiscatter", "sampled", "truth"},
                  "multiscatter",
                  "Glossy reflection: none; the sharp cube; its box-filtered levels; levels filtered with GGX, looked "
                  "up along the mirror direction or the dominant one; with multiple scattering; sampled for each "
                  "pixel; or summed over all texels"};
    Choice sh_window{*this,
                     "sh_window",
                     {"none", "hann", "sinc4"},
                     "none",
                     "Window on the spherical harmonics: none, Hann of width 5, or sinc^4 of width 3"};
    Knob<int> samples{*this, "samples", 64, {1, 4096}, "Samples of each pixel, for the method 'sampled'"};
    Knob<float> sample_bias{
        *this,   "sample_bias", 1.0f, {0.0f, 8.0f}, "Added to the level that each sample of a pixel is read from",
        "levels"};
    Knob<float> limit{*this,
                      "limit",
                      65504.0f,
                      {0.01f, 65504.0f},
                      "Radiance of the picture above which it is cut off; half floats end at 65504"};
    Knob<float> intensity{
        *this, "intensity", 1.0f, {0.0f, 1e4f}, "Scale factor for the environment's radiance, besides the scene's own"};
    Knob<float> turn_deg{
        *this, "turn_deg", 0.0f, {-360.0f, 360.0f}, "Rotation of the environment about +y, besides the scene's own",
        "°"};

    /// Fills the cubes where the scene has another picture than they were made from, or where a knob that they depend on
    /// has changed; else records nothing.
    void record(Frame& frame, const Scene& scene);

    /// Makes all that is made from the first level of drawn.radiance. `box`: how it is looked up from elsewhere; levels
    /// and texels are filled in.
    void record_drawn(Frame& frame, const ImageLightState& box);

    /// True: only radiance and its mip levels, for passes that sample single directions, radiance_along(). Filtering
    /// costs far more.
    bool radiance_alone = false;

    /// Which of the two shaders get from now on. record() and record_drawn() choose their own.
    void use(LightCubes& cubes) { now_ = &cubes; }

    void prepare(Gpu& gpu, Scene& scene) override;
    std::vector<std::string> load_exercises() const override { return {"14.sh_project"}; }
    std::vector<Resource> reads() const override {
        if (radiance_alone) return {now_->radiance};
        return {now_->radiance, now_->prefiltered, now_->irradiance, table, now_->sh};
    }
    void bind(Pass& pass) const override;

    Prefilter prefilter{*this, "prefilter"};
    MipChain levels{*this, "levels"};
    LightCubes sky{*this, "sky"}, drawn{*this, "drawn"};
    Target table{*this, {.name = "table", .size = {64, 64}, .kept = true}};

  private:
    const Image& picture_of(Frame& frame, const Scene& scene);
    void record_table(Frame& frame);
    void filter(Frame& frame, LightCubes& cubes);

    Pipeline to_cube_ = compute({.shader = "14_environment/equirect_to_cube.comp"});
    Pipeline face_ = compute({.shader = "14_environment/prefilter.comp"});
    Pipeline irradiance_ = compute({.shader = "14_environment/irradiance.comp"});
    Pipeline sh_sums_ = compute({.shader = "14_environment/sh_sums.comp"});
    Pipeline split_sum_ = compute({.shader = "14_environment/split_sum.comp"});
    const Scene* scene_ = nullptr;
    /// Picture, ambient, toggles: a scene that is prepared again with the same light keeps its cubes.
    Fingerprint prepared_;
    std::shared_ptr<Image> environment_;  ///< that picture_sh_ is of
    Image even_;                          ///< where there is no picture
    Sh9 picture_sh_{};                    ///< of the scene's picture, as 14.sh_project says
    LightCubes* now_ = &sky;
    ImageLightState box_{};
    Fingerprint made_;
    Fingerprint table_made_;
};

/// The largest level of an RGBA16F picture that is at most `most` texels wide, as numbers. Waits for the device.
ImageRgb small_picture(Gpu& gpu, const Image& picture, uint32_t most);

/// The windows that keep spherical harmonics from ringing: the factor of degree 0, 1 and 2.
std::array<double, 3> sh_window(size_t which);

}  // namespace lightwalk
