// Quaternion Julia sets, met by rays.
#pragma once
#include "11_fractals/environment.h"
#include "11_fractals/julia_data.h"
#include "common/app/drawing.h"

namespace lightwalk {

struct JuliaLook : Module {
    using Module::Module;
    Knob<glm::vec3> color{*this,
                          "color",
                          glm::vec3(0.85f, 0.62f, 0.38f),
                          {glm::vec3(0.0f), glm::vec3(1.0f)},
                          "albedo where orbits stay away"};
    Knob<glm::vec3> color_deep{*this,
                               "color_deep",
                               glm::vec3(0.3f, 0.07f, 0.05f),
                               {glm::vec3(0.0f), glm::vec3(1.0f)},
                               "albedo where they come near"};
    Knob<float> shininess{*this, "shininess", 40.0f, {1.0f, 2000.0f}, "Phong exponent of the light's highlight"};
    Knob<float> gloss{*this, "gloss", 0.3f, {0.0f, 10.0f}, "strength of that highlight"};
    Knob<float> facing{*this, "facing", 0.06f, {0.0f, 1.0f}, "what is reflected where one looks along the normal"};
    Knob<glm::vec3> mirror{*this,
                           "mirror",
                           glm::vec3(1.0f),
                           {glm::vec3(0.0f), glm::vec3(1.0f)},
                           "by what the reflection is multiplied: a metal's colour"};
    Knob<float> fresnel_power{*this, "fresnel_power", 1.0f, {0.05f, 16.0f}, "k of the reflection 1 - (v.n)^k"};
    Knob<float> background_level{
        *this, "background_level", 0.0f, {0.0f, 8.0f}, "how blurred the environment is behind the set"};
};

// [julia]
/// A drawing under the scene's sun and what surrounds it: where each pixel's ray meets the set, and then its light. What
/// lies beyond it is the environment, or what others have drawn.
struct Julia : Drawing {
    Julia(Module& owner, std::string name, EnvironmentLight& environment)
        : Drawing(owner, std::move(name), "julia"), environment_(environment) {}

    Choice method{*this,
                  "method",
                  {"fixed", "distance", "relaxed", "cone", "exact"},
                  "cone",
                  "how a ray goes: steps of one length; as far as nothing can be; farther, and back where that was too "
                  "far; in cones down to a pixel's footprint; the truth's small steps"};
    // [/julia]
    Choice normal{*this, "normal", {"analytic", "difference"}, "analytic", "how the surface's normal is found"};
    Choice fresnel{*this, "fresnel", {"schlick", "power"}, "schlick", "how reflection grows towards the rim"};
    Choice show{*this, "show", {"picture", "normals", "steps"}, "picture", "steps: how many a ray took; white: capped"};
    Knob<bool> shadow{*this, "shadow", true, "the set casts a shadow on itself"};
    Choice constant{*this,
                    "constant",
                    {"custom", "cauldron", "reef", "shell", "knot", "thorn", "spindle", "dust", "morph"},
                    "reef",
                    "c of z² + c, from the gallery; morph: one after the other, as time goes"};
    Knob<glm::vec3> c_xyz{*this,
                          "c_xyz",
                          glm::vec3(-0.2f, 0.8f, 0.0f),
                          {glm::vec3(-2.0f), glm::vec3(2.0f)},
                          "custom: real part, i and j of c"};
    Knob<float> c_k{*this, "c_k", 0.0f, {-2.0f, 2.0f}, "custom: k of c"};
    Knob<float> slice{*this, "slice", 0.0f, {-2.0f, 2.0f}, "k of the points that are shown: which slice"};
    Knob<int> iterations{*this, "iterations", 40, {1, 256}, "turns after which a point is taken for one of the set"};
    Knob<float> escape{*this, "escape", 8.0f, {2.0f, 64.0f}, "|z| from which on a point has escaped"};
    Knob<float> step_m{*this, "step_m", 0.01f, {1e-4f, 1.0f}, "fixed: length of a step", "m"};
    Knob<float> epsilon_m{*this, "epsilon_m", 5e-4f, {1e-5f, 0.1f}, "distance, relaxed: near enough", "m"};
    Knob<float> relaxation{*this, "relaxation", 1.4f, {1.0f, 2.0f}, "relaxed: length of a step, in distances"};
    Knob<float> footprint{*this, "footprint", 0.1f, {0.01f, 4.0f}, "cone: near enough, in widths of a pixel", "px"};
    Knob<float> trust{
        *this, "trust", 1.0f, {0.05f, 1.0f}, "share of a distance that is believed: less for sets that fall to dust"};
    Knob<float> difference_m{*this, "difference_m", 2e-4f, {1e-6f, 0.1f}, "how far apart a normal's differences are",
                             "m"};
    Knob<int> most_steps{*this, "most_steps", 256, {1, 4096}, "distances after which a ray is stopped"};
    JuliaLook look{*this, "look", "julia_look"};

    void prepare(Gpu&, Scene& loaded) override { scene_ = &loaded; }
    void update(Frame& frame) override { environment_.record(frame, *scene_); }
    void draw(Frame& frame, const View& view, Canvas& canvas) override;

    /// c at a time; with constants that do not move, at any.
    glm::vec4 constant_at(double time_s) const;
    bool animated() const override { return constant.is("morph"); }

    std::vector<Resource> reads() const override { return {}; }
    void bind(Pass& pass) const override { pass.offer("julia_now", now_); }

    /// Of each pixel: metres along the ray, distances asked for, and MARCH_... of 11_fractals/march_along.glsl.
    Image found;

  private:
    void march(Frame& frame, const View& view);
    static constexpr uint32_t tile = 8;  ///< pixels
    EnvironmentLight& environment_;
    const Scene* scene_ = nullptr;
    Image starts_, own_color_;
    Pipeline merge_ = graphics({.vertex = "06_deferred/whole.vert", .fragment = "11_fractals/julia_merge.frag"});
    Pipeline cone_ = compute({.shader = "11_fractals/julia_cone.comp"});
    Pipeline march_ = compute({.shader = "11_fractals/julia_march.comp"});
    Pipeline shade_ = compute({.shader = "11_fractals/julia_shade.comp"});
    JuliaNow now_{};
};

/// The largest |z| of a point that never escapes, of any Julia set of that constant: |z|² - |c| = |z|.
float julia_bound(glm::vec4 constant);

}  // namespace lightwalk
