// Water drawing: a surface of waves that reflects, refracts and foams.
#pragma once
#include "13_mlaa/moving.h"
#include "14_environment/image_light.h"
#include "15_terrain_water/ocean.h"
#include "15_terrain_water/waterline_data.h"
#include "common/app/module.h"
#include "common/app/world.h"
#include "common/base/epoch.h"
#include "common/gpu/frame.h"
#include "common/scene/scene.h"
#include "common/scene/view.h"

namespace lightwalk {

/// record() in each frame; then shaders with 15_terrain_water/waterline.glsl know the distance to the nearest object that
/// crosses the water. A point of the water's plane is inside of an object where the ray upwards leaves it once more often
/// than it enters. That holds for closed surfaces alone.
struct Waterline : Module {
    Waterline(Module& owner, std::string name);

    Choice method{*this,
                  "method",
                  {"none", "rings"},
                  "none",
                  "Water around objects that stand in it: undisturbed, or with rings of small waves and foam (rings)"};
    Knob<float> length_m{*this, "length_m", 0.14f, {0.005f, 100.0f}, "Length of the longest ring wave", "m"};
    Knob<float> slope{*this, "slope", 0.16f, {0.0f, 1.0f}, "Steepness of the rings at the waterline"};
    Knob<float> reach_m{
        *this, "reach_m", 0.5f, {0.01f, 100.0f}, "Distance over which the longest ring wave falls to 37%", "m"};
    Knob<float> foam_m{*this, "foam_m", 0.05f, {0.0f, 10.0f}, "Width of the foam around an object", "m"};
    Knob<int> texels{*this, "texels", 512, {16, 4096}, "Width and height of the map of distances"};

    /// Draws the map again where objects, the level or a knob have changed. `level_m`: of the water at rest; waves come from
    /// the direction `from_wind` (x and z, unit length).
    void record(Frame& frame, const Scene& scene, float level_m, glm::vec2 from_wind);
    /// Whether an object crosses the level; only then is there a map to read.
    bool exists() const { return exists_; }
    const Image& distances() const { return distances_; }  ///< R32F, metres
    const WaterlineMap& map() const { return map_; }

    void bind(Pass& pass) const override;
    std::vector<Resource> reads() const override;

  private:
    void draw(Frame& frame, const DrawList& crossing, float level_m, float top_m);
    void spread(Frame& frame);
    Image windings_, along_rows_, distances_;
    WaterlineMap map_{};
    bool exists_ = false;
    Fingerprint made_;
    Pipeline wind_ = graphics({.vertex = "05_shadow_maps/caster.vert",
                               .fragment = "15_terrain_water/winding.frag",
                               .cull = VK_CULL_MODE_NONE,
                               .blend = Blend::add});
    Pipeline rows_ = compute({.shader = "15_terrain_water/waterline_distance.comp", .macros = {{"VERTICAL", "0"}}});
    Pipeline columns_ = compute({.shader = "15_terrain_water/waterline_distance.comp", .macros = {{"VERTICAL", "1"}}});
};

/// record() before the water is drawn; then image() holds the reflection of the level water at each pixel, counted
/// from the opposite edge. Water among the drawings is omitted: a mirror does not see itself.
struct Mirror : Module {
    Mirror(Module& owner, std::string name);

    Knob<float> scale{*this, "scale", 0.5f, {0.1f, 1.0f}, "Width of the mirror image, as a share of the picture's"};

    /// Opaque drawings are drawn with the water as their near plane, then sky, air and fog behind and before them.
    void record(Frame& frame, const View& view, float level_m, const Drawings& drawings);
    void record(Frame& frame, const View& view, float level_m, World& world) {
        record(frame, view, level_m, world.prepare_view(frame, view));
    }
    const Image& image() const { return color_; }
    const Image& depth() const { return depth_; }  ///< as the mirrored camera's own near and far planes give it

  private:
    DerivedViews views_;
    Image color_, oblique_, depth_;
    Pipeline plain_depth_ = graphics({.vertex = "06_deferred/whole.vert",
                                      .fragment = "15_terrain_water/plain_depth.frag",
                                      .cull = VK_CULL_MODE_NONE,
                                      .depth_compare = Compare::always});
};

/// The camera below the water that sees the mirrored view, flipped left to right.
Camera mirrored_camera(const Camera& camera, float level_m);

/// Follows reflected rays, for Water: `rays` has in each pixel a direction and the metres along the view to the ray's
/// origin (0: no ray). Writes into `met` (RGBA16F, same size) the light of the hit, and the share of background light
/// that it hides.
struct WaterRays {
    virtual ~WaterRays() = default;
    virtual void find_casters(const Drawings&) {}  ///< as a drawing is told
    virtual void record(Frame& frame, const View& view, const Image& rays, const Image& met) = 0;
};

/// In a frame, with everything that is drawn:
///
///     water.reflect(frame, view, drawings);
///     draw(frame, view, canvas, drawings);
///
/// `light`: the surroundings, for rays that leave the picture; the owner records it before.
struct Water : Drawing, MovingSurface {
    Water(Module& owner, std::string name, const ImageLight& light);

    Choice method{*this,
                  "method",
                  {"none", "flat", "sines", "gerstner", "fft"},
                  "gerstner",
                  "Water surface: none, level, a sum of sines, a sum of Gerstner waves, or a wave spectrum by Fourier "
                  "transforms"};
    Choice reflection{*this,
                      "reflection",
                      {"none", "cube", "screen_space", "planar", "rays"},
                      "planar",
                      "Reflection: none, the surroundings in a cube, the picture itself where it shows what is met, "
                      "the scene drawn from below, or a ray for each pixel (the reference)"};
    Knob<float> level_m{*this, "level_m", 0.0f, {-1e4f, 1e4f}, "Height of the water at rest", "m"};
    Knob<int> waves{*this, "waves", 12, {2, 16}, "Number of waves (methods sines and gerstner)"};
    Knob<float> longest_m{*this, "longest_m", 12.0f, {0.01f, 1000.0f}, "Length of the longest wave", "m"};
    Knob<float> shortest_m{*this, "shortest_m", 0.7f, {0.01f, 1000.0f}, "Length of the shortest wave", "m"};
    Knob<float> slope{*this, "slope", 0.05f, {0.0f, 1.0f}, "Steepness of each wave: wave number times amplitude"};
    Knob<float> steepness{*this,
                          "steepness",
                          0.7f,
                          {0.0f, 4.0f},
                          "Sum over all waves of steepness, wave number and amplitude; above 1 the surface loops"};
    Knob<float> wind_deg{
        *this, "wind_deg", 25.0f, {-360.0f, 360.0f}, "Mean direction of the waves, from +x towards +z", "degrees"};
    Knob<float> spread_deg{*this, "spread_deg", 50.0f, {0.0f, 180.0f}, "Largest angle of a wave to that", "degrees"};
    Knob<glm::vec3> absorption{*this,
                               "absorption",
                               {0.45f, 0.11f, 0.07f},
                               {glm::vec3(0.0f), glm::vec3(100.0f)},
                               "Absorption coefficient of the water",
                               "1/m"};
    Knob<glm::vec3> turbid{
        *this, "turbid", {0.008f, 0.032f, 0.038f}, {glm::vec3(0.0f), glm::vec3(1.0f)}, "Albedo of deep water"};
    Knob<float> roughness{
        *this, "roughness", 0.03f, {0.0f, 0.5f}, "Standard deviation of the slopes of ripples finer than any wave"};
    Knob<float> refraction{*this, "refraction", 0.25f, {0.0f, 1.0f}, "Shift of what lies below the surface"};
    Knob<float> foam{*this, "foam", 0.35f, {-10.0f, 1.0f}, "Jacobian below which the surface foams; it folds below 0"};
    Knob<float> shore_m{*this, "shore_m", 0.0f, {0.0f, 100.0f}, "Depth of the water up to which its shore foams", "m"};
    Knob<float> foam_m{*this, "foam_m", 4.0f, {0.01f, 1000.0f}, "Side of a tile of foam", "m"};
    Ocean ocean{*this, "ocean"};
    Mirror mirror{*this, "mirror"};
    Waterline waterline{*this, "waterline"};

    WaterRays* tracer = nullptr;  ///< for reflection by rays; null: these meet nothing but the surroundings

    void prepare(Gpu&, Scene& loaded) override;
    bool animated() const override { return method.is("flat") ? waterline.exists() : !method.is("none"); }
    /// Whether its reflection looks into the surroundings' cube: a mirror image, and no reflection, do without.
    bool sees_surroundings(const View& view) const;
    /// The mirror image, where that is the method and the eye is above the water.
    void reflect(Frame& frame, const View& view, const Drawings& drawings);
    void find_casters(const Drawings& drawings) override {
        if (tracer) tracer->find_casters(drawings);
    }
    void update(Frame& frame) override;
    Phase draw_phase() const override { return Phase::water; }
    void draw(Frame& frame, const View& view, Canvas& canvas) override;
    void bind(Pass& pass) const override;
    bool has_moved() const override;
    void draw_motion(Frame& frame, const MotionPass& given) const override;

    /// At `time_s`; phases are right to a millionth of a radian after years.
    std::vector<WaveData> waves_at(double time_s) const;
    /// Height of the surface above a place, by the sum of waves; of other methods the level.
    float height_above(glm::vec2 place, double time_s) const;

  private:
    /// Whether the view has a mirror image.
    bool is_mirrored(const View& view) const;
    WaterNow now(const Frame& frame, const View& view) const;
    Macros around_objects() const;
    void follow_rays(Frame& frame, const View& view, Canvas& canvas);
    const ImageLight& light_;
    const Scene* scene_ = nullptr;
    Image behind_, behind_depth_, foam_tile_, black_, rays_, met_;
    Buffer rings_;  ///< indices
    bool has_foam_ = false;
    uint32_t mirrored_ = ~0u;  ///< the view of which there is a mirror image
    WaterNow now_{};
    /// The frame's own view of the water, now and in the frame before.
    struct Kept : TargetBase {
        using TargetBase::TargetBase;
        void begin_frame(Gpu&, glm::uvec2) override;
        void forget() override { now.method = before.method = none; }
        static constexpr size_t none = ~size_t(0);
        struct State {
            size_t method = none;  ///< none: not drawn
            double time_s = 0;
            bool has_rings = false;
            glm::vec3 ring_phase{0};
            WaterNow water{};
        } now, before;
    } kept_{*this};
    Pipeline keep_ = compute({.shader = "15_terrain_water/keep_depth.comp"});
    Pipeline foam_ = compute({.shader = "15_terrain_water/foam_tile.comp"});
    Pipeline under_ = compute({.shader = "15_terrain_water/under_water.comp"});
    Pipeline rays_of_ = graphics({.vertex = "15_terrain_water/water.vert",
                                  .fragment = "15_terrain_water/water_rays.frag",
                                  .cull = VK_CULL_MODE_NONE});
    Pipeline moved_ = graphics({.vertex = "15_terrain_water/water.vert",
                                .fragment = "15_terrain_water/water_moved.frag",
                                .cull = VK_CULL_MODE_NONE,
                                .depth_test = false,
                                .depth_write = false});
    Pipeline surface_ = graphics({.vertex = "15_terrain_water/water.vert",
                                  .fragment = "15_terrain_water/water.frag",
                                  .cull = VK_CULL_MODE_NONE});
};

/// By how much the water that rests at `at` is moved, in double precision: the sum of gerstner().
glm::dvec3 moved_by(const std::vector<WaveData>& waves, glm::dvec2 at);

/// Height above a place from which water was moved away: `rounds` of a fixed-point search for the water that came there.
double height_at(const std::vector<WaveData>& waves, glm::dvec2 place, int rounds = 4);

}  // namespace lightwalk
