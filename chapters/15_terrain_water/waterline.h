// Waterline module: rings of small waves and foam around whatever stands in the water.
#pragma once
#include "15_terrain_water/waterline_data.h"
#include "common/app/module.h"
#include "common/base/epoch.h"
#include "common/gpu/frame.h"
#include "common/scene/scene.h"
#include "common/scene/view.h"

namespace lightwalk {

// [waterline]
/// record() in each frame; then shaders with 15_terrain_water/waterline.glsl know the distance to the nearest object that
/// crosses the water. A point of the water's plane is inside of an object where the ray upwards leaves it once more often
/// than it enters. That holds for closed surfaces alone.
struct Waterline : Module {
    Waterline(Module& owner, std::string name) : Module(owner, std::move(name), "waterline") {}

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
    // [/waterline]

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

}  // namespace lightwalk
