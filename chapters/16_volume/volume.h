// A volume as a drawing: emission and absorption along each pixel's ray.
#pragma once
#include <glm/glm.hpp>
#include <map>
#include <string>
#include <vector>

#include "16_volume/field.h"
#include "common/app/drawing.h"
#include "common/base/epoch.h"

namespace lightwalk {

/// TRANSFER_TEXELS entries over densities from 0 to 1: linear colour, and the opacity of REFERENCE_M metres. `name` is one
/// of transfer_names(); throws std::out_of_range otherwise. `density` (0 or more) multiplies the optical depth.
std::vector<glm::vec4> transfer_function(const std::string& name, float density);

const std::vector<std::string>& transfer_names();

/// The table of chapter 16's pre-integration: `texels` squared entries, row by row the density behind, in a row the one in
/// front, for steps of `ratio` reference lengths: light that is weighted by opacity already, and opacity.
std::vector<glm::vec4> preintegrated_table(const std::vector<glm::vec4>& transfer, int texels, float ratio);

/// The thinnest layer that the transfer function shows, as a share of the range of densities: the shortest run of entries
/// above half of a peak of opacity. 1 where there is none.
float thinnest_layer(const std::vector<glm::vec4>& transfer);

/// Extinction that the transfer function does not exceed, 1/m; above 0.
float majorant(const std::vector<glm::vec4>& transfer);

/// Drawn after all solid objects; their depth ends its rays. Transparent: it writes no depth. The box of its field
/// stands around the world's origin, its longest edge 2 m long.
struct Volume : Drawing {
    Volume(Module& owner, std::string name);

    Choice method{*this,
                  "method",
                  {"sum", "trapezium", "midpoint", "jittered", "skipping", "preintegrated", "exact"},
                  "skipping",
                  "Integration along the ray: densities times lengths (sum), the mean of each step's two ends "
                  "(trapezium), its middle (midpoint), a random place in it, averaged over pictures (jittered), the "
                  "middle, without empty blocks (skipping), a table over both ends (preintegrated), or the reference "
                  "(exact)"};
    Knob<int> steps{*this, "steps", 256, {1, 4096}, "Number of samples along the box's longest edge"};
    Knob<int> truth_samples{*this, "truth_samples", 16, {1, 192}, "Reference: samples per voxel"};
    Choice transfer{*this,
                    "transfer",
                    {"nebula", "skin", "inside", "shell", "even"},
                    "nebula",
                    "Transfer function: which colour and opacity a density has"};
    Knob<float> density{*this, "density", 1.0f, {0.0f, 1000.0f}, "Scale factor for the optical depth"};
    Knob<float> glow{*this, "glow", 0.35f, {0.0f, 100.0f}, "Radiance of opaque matter by itself, times its colour"};
    Choice light{
        *this,
        "light",
        {"none", "march", "volume"},
        "volume",
        "Light that reaches a sample: none; by a second march from each; read from a volume of half resolution"};
    Choice light_from{
        *this, "light_from", {"heart", "sun"}, "heart", "Light source: a lamp in the middle, or the scene's sun"};
    Knob<glm::vec3> heart{*this,
                          "heart",
                          {1.5f, 1.15f, 0.85f},
                          {glm::vec3(0.0f), glm::vec3(1e4f)},
                          "Irradiance 1 m from the lamp in the middle"};
    Choice scattering{*this,
                      "scattering",
                      {"none", "single", "octaves", "conserving", "walk"},
                      "none",
                      "Scattering by the volume: matter emits and reflects as the transfer function says (none); light "
                      "scattered once (single), also many times by a sum of octaves, or by octaves that share the "
                      "light out (conserving); random walks (the reference)"};
    Knob<float> albedo{*this, "albedo", 1.0f, {0.0f, 1.0f}, "Scattered share of the light that matter meets"};
    Knob<float> g{*this, "g", 0.85f, {-0.95f, 0.95f}, "Mean cosine of the scattering angle"};
    Knob<glm::vec3> sky{*this,
                        "sky",
                        {0.0f, 0.0f, 0.0f},
                        {glm::vec3(0.0f), glm::vec3(1e4f)},
                        "Radiance that arrives from all sides and is scattered"};
    Knob<int> octaves{*this, "octaves", 6, {1, 10}, "Number of octaves of scattered light"};
    Knob<int> paths{*this, "paths", 4, {1, 64}, "Number of random walks per pixel and picture (scattering walk)"};
    Knob<int> light_steps{*this, "light_steps", 24, {1, 128}, "Number of samples on the way to the light"};
    Choice shading{*this,
                   "shading",
                   {"none", "gradient"},
                   "none",
                   "Reflection: the same in all directions, or as a surface across the gradient"};
    Knob<float> shine{*this, "shine", 0.2f, {0.0f, 10.0f}, "Strength of the highlights of gradient shading"};
    Knob<float> threshold{*this, "threshold", 0.002f, {1e-6f, 1.0f}, "Largest radiance that an early exit may lose"};
    Knob<float> brightest{
        *this, "brightest", 60.0f, {0.0f, 1e5f}, "Radiance that nothing on a ray exceeds, for the early exit"};
    Knob<float> wave{*this, "wave", 0.0f, {0.0f, 0.2f}, "Amplitude of the waves, as a share of the box's edge"};
    Knob<float> wave_speed{*this, "wave_speed", 0.7f, {0.0f, 100.0f}, "Angular speed of the waves", "rad/s"};
    Knob<bool> shell{*this, "shell", true, "A shell of glass around the ball that reflects what surrounds it"};
    Choice noise{
        *this,
        "noise",
        {"lattice", "simplex", "texture"},
        "lattice",
        "4-D noise of the shell's normals: 16 corners of a lattice, 5 of a simplex, or two reads of a texture"};
    Knob<float> shell_strength{*this, "shell_strength", 1.0f, {0.0f, 1.0f}, "Scale factor for the shell's reflection"};
    Knob<float> shell_bumps{*this, "shell_bumps", 0.05f, {0.0f, 2.0f}, "Height of the shell's bumps"};
    Knob<float> shell_scale{*this, "shell_scale", 3.0f, {0.1f, 64.0f}, "Number of noise cells in the shell's radius"};
    Knob<float> shell_speed{*this, "shell_speed", 0.6f, {0.0f, 100.0f}, "Noise cells that the shell passes in a second",
                            "1/s"};
    Choice show{*this,
                "show",
                {"picture", "blocks", "error", "noise"},
                "picture",
                "Image shown: the picture; the edges of full and empty blocks; 16 times the error against four samples "
                "per voxel; the shell's noise at four moments"};
    Field field{*this, "field"};

    void prepare(Gpu&, Scene& loaded) override;
    bool animated() const override { return wave > 0 || (shell && !field.is_file()) || averages(); }
    void update(Frame& frame) override;
    bool load_proxy(const std::filesystem::path& file, Model&) const override { return is_volume_file(file); }
    Phase draw_phase() const override { return Phase::air; }
    void draw(Frame& frame, const View& view, Canvas& canvas) override;
    void bind(Pass& pass) const override;
    std::vector<Resource> reads() const override;

    const Image& blocks() const { return pyramid_.blocks(); }
    int pictures(uint32_t view) const;  ///< of the mean last shown by `jittered` or by walks

  private:
    bool averages() const { return method.is("jittered") || scattering.is("walk"); }
    void make_transfer(Frame& frame);
    void make_tables(Frame& frame);
    void make_light(Frame& frame);
    VolumeNow now(const Frame& frame) const;
    const Scene* scene_ = nullptr;
    BlockPyramid pyramid_;
    VolumeNow now_{};
    Image transfer_, light_, preintegrated_, noise_;
    uint64_t transfer_number_ = 0;
    Fingerprint transfer_made_;
    Fingerprint preintegrated_made_;
    Fingerprint light_made_;
    struct Past {  ///< of a view
        Image marched;
        std::string of;  ///< key of its picture
        int pictures = 0;
    };
    std::map<uint32_t, Past> past_;
    std::vector<glm::vec4> transfer_texels_;
    Pipeline march_ = compute({.shader = "16_volume/march.comp"});
    Pipeline make_light_ = compute({.shader = "16_volume/make_light.comp"});
    Pipeline make_noise_ = compute({.shader = "16_volume/make_noise.comp"});
};

/// Time as noise wants it: whole cells and the rest. `cells` may be as many as 2^31.
NoiseMoment noise_moment(double cells, int seed);

}  // namespace lightwalk
