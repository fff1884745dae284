// Car paint as a module: a model of layers, or a measured BRDF.
#pragma once
#include <optional>

#include "14_environment/measured_brdf.h"
#include "14_environment/paint_fit.h"
#include "common/app/module.h"
#include "common/app/target.h"
#include "common/base/epoch.h"
#include "common/gpu/frame.h"
#include "common/scene/scene.h"

namespace lightwalk {

/// Gives shaders paint_brdf(), paint_albedo() and flake_light() of 14_environment/paint.glsl, for surfaces with a
/// material called "paint". record() before the first pass that states it in `.with`. Measured is the first object of the
/// scene with a .binary file as model, or assets/tables/flakes.binary.
struct CarPaint : Module {
    CarPaint(Module& owner, std::string name);

    Choice method{*this,
                  "method",
                  {"layers", "averaged", "fit", "measured"},
                  "layers",
                  "Paint in the lights of a scene: a table over (n·l, n·v) of a model of layers; such a table of a "
                  "measured BRDF, "
                  "averaged over the azimuth; that model, fitted to it; the measured BRDF itself. Only layers has the "
                  "colours below"};
    Knob<bool> coat{*this, "coat", true, "Clear coat's reflection; off for a measured BRDF that includes its own"};
    Knob<glm::vec3> color{
        *this, "color", {0.35f, 0.008f, 0.012f}, {glm::vec3(0), glm::vec3(1)}, "Pigment's albedo, seen straight on"};
    Knob<glm::vec3> edge_color{*this,
                               "edge_color",
                               {0.09f, 0.002f, 0.02f},
                               {glm::vec3(0), glm::vec3(1)},
                               "Pigment's albedo at grazing angles"};
    Knob<glm::vec3> flake_color{
        *this, "flake_color", {0.95f, 0.35f, 0.25f}, {glm::vec3(0), glm::vec3(1)}, "Reflectance of the metal flakes"};
    Knob<float> flakes{*this, "flakes", 0.25f, {0.0f, 1.0f}, "Share of the paint that the flakes cover"};
    Knob<float> flake_roughness{
        *this, "flake_roughness", 0.45f, {0.1f, 1.0f}, "Spread of the flakes' normals, as a roughness"};
    Knob<float> coat_roughness{*this, "coat_roughness", 0.05f, {0.0f, 1.0f}, "Roughness of the clear coat"};
    Knob<float> flake_mm{*this, "flake_mm", 1.0f, {0.05f, 50.0f}, "Distance from one flake to the next", "mm"};

    /// Makes the table where a knob has changed.
    void record(Frame& frame);
    void prepare(Gpu&, Scene& scene) override;
    bool load_proxy(const std::filesystem::path& file, Model&) const override { return is_measured_file(file); }
    std::vector<Resource> reads() const override;
    void bind(Pass& pass) const override;

    bool is_given() const { return given_; }  ///< the scene names a measured BRDF
    size_t bytes() const;                     ///< that a light's look-up reads from

    Target table{*this, {.name = "table", .size = {64, 66}, .kept = true}};

  private:
    void load(Frame& frame);
    bool given_ = false;
    std::optional<MeasuredBrdf> brdf_;
    PaintFit fit_;
    Image measured_;  ///< RGBA16F: φd, θd, θh
    Fingerprint made_;
    Pipeline fill_ = compute({.shader = "14_environment/paint_table.comp"});
};

/// Gives shaders the buffer `substances` of 14_environment/substance_data.h, an entry for each of the scene's items.
struct Substances : Module {
    Substances(Module& owner, std::string name) : Module(owner, std::move(name), "substance") {}

    Knob<float> roughness{
        *this, "roughness", -1.0f, {-1.0f, 1.0f}, "Roughness of all surfaces; below 0 each has its own"};

    void prepare(Gpu& gpu, Scene& scene) override;
    std::vector<Resource> reads() const override { return {substances_}; }
    void bind(Pass& pass) const override { pass.set_if_present("substances", substances_); }

  private:
    Buffer substances_;
};

}  // namespace lightwalk
