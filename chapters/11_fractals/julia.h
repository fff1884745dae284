// Julia drawing: quaternion Julia sets rendered by ray marching.
#pragma once
#include "11_fractals/julia_data.h"
#include "common/app/drawing.h"
#include "common/app/environment.h"

namespace lightwalk {

struct JuliaLook : Module {
    using Module::Module;
    Knob<glm::vec3> color{*this,
                          "color",
                          glm::vec3(0.85f, 0.62f, 0.38f),
                          {glm::vec3(0.0f), glm::vec3(1.0f)},
                          "Albedo where orbits stay away from the origin"};
    Knob<glm::vec3> color_deep{*this,
                               "color_deep",
                               glm::vec3(0.3f, 0.07f, 0.05f),
                               {glm::vec3(0.0f), glm::vec3(1.0f)},
                               "Albedo where orbits come near to the origin"};
    Knob<float> shininess{*this, "shininess", 40.0f, {1.0f, 2000.0f}, "Phong exponent of the highlight of the sun"};
    Knob<float> gloss{*this, "gloss", 0.3f, {0.0f, 10.0f}, "Strength of the highlight of the sun"};
    Knob<float> facing{*this, "facing", 0.06f, {0.0f, 1.0f}, "Reflectance F0 at normal incidence"};
    Knob<glm::vec3> mirror{*this,
                           "mirror",
                           glm::vec3(1.0f),
                           {glm::vec3(0.0f), glm::vec3(1.0f)},
                           "Colour of the reflection, as of a metal"};
    Knob<float> fresnel_power{
        *this, "fresnel_power", 1.0f, {0.05f, 16.0f}, "Exponent k of the reflectance 1 - (v.n)^k"};
    Knob<float> background_level{
        *this, "background_level", 0.0f, {0.0f, 8.0f}, "Blur of the environment behind the set, as a mip level"};
};

/// A drawing under the scene's sun and environment: each pixel's hit, then its light. The background is the environment
/// or earlier drawings.
struct Julia : Drawing {
    Julia(Module& owner, std::string name, EnvironmentLight& environment);

    Choice method{*this,
                  "method",
                  {"fixed", "distance", "relaxed", "cone", "exact"},
                  "cone",
                  "Ray marching: fixed steps; sphere tracing; relaxed sphere tracing; cones, down to a pixel's "
                  "footprint; small steps (reference)"};
    Choice normal{*this,
                  "normal",
                  {"analytic", "difference"},
                  "analytic",
                  "Surface normal: derivative of the iteration, or differences of distances"};
    Choice fresnel{*this,
                   "fresnel",
                   {"schlick", "power"},
                   "schlick",
                   "Reflectance towards the silhouette: Schlick's, or the power 1 - (v.n)^k"};
    Choice show{
        *this,
        "show",
        {"picture", "normals", "steps"},
        "picture",
        "Picture shown: the shaded set, its normals, or the number of steps of each ray (white: limit reached)"};
    Knob<bool> shadow{*this, "shadow", true, "Shadow of the set on itself"};
    Choice constant{*this,
                    "constant",
                    {"custom", "cauldron", "reef", "shell", "knot", "thorn", "spindle", "dust", "morph"},
                    "reef",
                    "Constant c of z² + c: custom, one from the gallery, or morph, which passes through the gallery"};
    Knob<glm::vec3> c_xyz{*this,
                          "c_xyz",
                          glm::vec3(-0.2f, 0.8f, 0.0f),
                          {glm::vec3(-2.0f), glm::vec3(2.0f)},
                          "Real part, i and j of c (constant custom)"};
    Knob<float> c_k{*this, "c_k", 0.0f, {-2.0f, 2.0f}, "Component k of c (constant custom)"};
    Knob<float> slice{*this, "slice", 0.0f, {-2.0f, 2.0f}, "Slice shown: component k of the points"};
    Knob<int> iterations{
        *this, "iterations", 40, {1, 256}, "Number of iterations after which a point counts as one of the set"};
    Knob<float> escape{*this, "escape", 8.0f, {2.0f, 64.0f}, "Escape radius: a point with a greater |z| has escaped"};
    Knob<float> step_m{*this, "step_m", 0.01f, {1e-4f, 1.0f}, "Length of a step (method fixed)", "m"};
    Knob<float> epsilon_m{
        *this, "epsilon_m", 5e-4f, {1e-5f, 0.1f}, "Distance that counts as a hit (methods distance, relaxed)", "m"};
    Knob<float> relaxation{
        *this, "relaxation", 1.4f, {1.0f, 2.0f}, "Length of a step as a multiple of the distance (method relaxed)"};
    Knob<float> footprint{
        *this, "footprint", 0.1f, {0.01f, 4.0f}, "Distance that counts as a hit, in widths of a pixel (method cone)",
        "px"};
    Knob<float> trust{*this, "trust", 1.0f, {0.05f, 1.0f}, "Scale factor for distances; below 1 for disconnected sets"};
    Knob<float> difference_m{
        *this, "difference_m", 2e-4f, {1e-6f, 0.1f}, "Spacing of the differences (normal difference)", "m"};
    Knob<int> most_steps{*this, "most_steps", 256, {1, 4096}, "Maximum number of distances per ray"};
    JuliaLook look{*this, "look", "julia_look"};

    void prepare(Gpu&, Scene& loaded) override { scene_ = &loaded; }
    void update(Frame& frame) override { environment_.record(frame, *scene_); }
    std::vector<const Module*> dependencies() const override { return {this, &environment_}; }
    void draw(Frame& frame, const View& view, Canvas& canvas) override;

    /// c at a time; with constants that do not move, at any.
    glm::vec4 constant_at(double time_s) const;
    bool animated() const override { return constant.is("morph"); }

    std::vector<Resource> reads() const override { return {}; }
    void bind(Pass& pass) const override { pass.set_if_present("julia_now", now_); }

    /// Of each pixel: metres along the ray, distances asked for, and MARCH_... of 11_fractals/march_along.glsl.
    Image found;

  private:
    void march(Frame& frame, const View& view);
    static constexpr uint32_t tile = 8;  ///< pixels
    EnvironmentLight& environment_;
    const Scene* scene_ = nullptr;
    Image starts_, own_color_;
    Pipeline merge_ = graphics(
        {.vertex = "06_deferred/whole.vert", .fragment = "11_fractals/julia_merge.frag", .cull = VK_CULL_MODE_NONE});
    Pipeline depth_ = graphics({.vertex = "06_deferred/whole.vert",
                                .fragment = "11_fractals/julia_merge.frag",
                                .cull = VK_CULL_MODE_NONE,
                                .macros = {{"DEPTH_ALONE", "1"}}});
    Pipeline cone_ = compute({.shader = "11_fractals/julia_cone.comp"});
    Pipeline march_ = compute({.shader = "11_fractals/julia_march.comp"});
    Pipeline shade_ = compute({.shader = "11_fractals/julia_shade.comp"});
    JuliaNow now_{};
};

/// The largest |z| of a point that never escapes, of any Julia set of that constant: |z|² - |c| = |z|.
float julia_bound(glm::vec4 constant);

}  // namespace lightwalk
