// City drawing: streets, blocks and houses by a seed, on the ground of a height map.
#pragma once
#include "10_atmosphere/atmosphere.h"
#include "15_terrain_water/city_data.h"
#include "15_terrain_water/ground.h"
#include "15_terrain_water/sun_shadow.h"
#include "common/app/drawing.h"
#include "common/base/epoch.h"
#include "common/scene/mesh.h"

namespace lightwalk {

struct CityPlan {
    glm::vec2 middle_m{0.0f};  ///< world x and z
    float radius_m = 1000;     ///< above 0
    float towers_m = 120;      ///< height of the highest houses
    int most_boxes = 20000;
    int seed = 1;
};

/// Boxes that stand close together, for culling: `first` and `count` in City's list.
struct CityBlock {
    glm::vec2 middle_m{0.0f};
    glm::ivec2 cell{0};  ///< in the grid of blocks; (0, 0) is in the middle of the city
    float reach_m = 0;
    uint32_t first = 0, count = 0;
};

/// Blocks of about 110 by 70 m between streets, of one to eight lots each; every lot has a house of one to three boxes,
/// the higher the nearer to the middle, and every street its lamps. Ends with the block at which there are most_boxes.
std::vector<CityBlock> plan_city(const CityPlan& plan, std::vector<CityBox>& boxes);

/// Comes after the ground. Buildings in water, below a height of 1 m, are omitted.
struct City : Drawing, Caster, SunReceiver {
    City(Module& owner, std::string name, const Ground& ground, const Atmosphere& atmosphere);

    Knob<int> most_boxes{*this, "most_boxes", 0, {0, 100000}, "Number of boxes at most; 0: no city"};
    Knob<float> x_km{*this, "x_km", 0.0f, {-1e4f, 1e4f}, "Middle of the city, eastwards of the world's origin", "km"};
    Knob<float> z_km{*this, "z_km", 0.0f, {-1e4f, 1e4f}, "Middle of the city, southwards of the world's origin", "km"};
    Knob<float> radius_km{*this, "radius_km", 1.0f, {0.05f, 100.0f}, "Radius of the city", "km"};
    Knob<float> towers_m{*this, "towers_m", 120.0f, {5.0f, 1000.0f}, "Height of the highest houses", "m"};
    Knob<int> plan_seed{*this, "plan_seed", 1, {0, 1000000}, "Seed of streets and houses"};
    Knob<float> lit{*this, "lit", 0.4f, {0.0f, 1.0f}, "Share of the windows that are lit, when their light is on"};
    Knob<float> lamps{*this, "lamps", 0.0f, {0.0f, 100.0f}, "Luminance of lit windows; 0: day", "kcd/m²"};

    void update(Frame& frame) override;
    const Drawing* sun_source() const override { return &atmosphere_; }
    std::vector<const Module*> dependencies() const override { return {this, &ground_, &atmosphere_}; }
    void draw(Frame& frame, const View& view, Canvas& canvas) override;
    size_t box_count() const { return boxes_.size(); }

    /// Radiance of a lit window, exposed, and a pixel's angle: city_light of 15_terrain_water/city_light.glsl.
    glm::vec2 light_of(const View& view) const { return {atmosphere_.exposure * lamps, view.pixel_rad()}; }

    Bounds bounds() const override;
    uint64_t placed() const override { return placed_; }
    std::vector<With> shadow_modules() const override;
    void cast(Raster& pass, const View& light) const override;

    /// For rays: 15_terrain_water/city_rays.glsl.
    void bind(Pass& pass) const override;

  private:
    void draw_visible(Raster& pass, const View& view) const;
    const Ground& ground_;
    const Atmosphere& atmosphere_;
    Fingerprint made_;
    CityPlan plan_;  ///< of the boxes that are there
    std::vector<CityBlock> blocks_;
    std::vector<CityBox> boxes_;
    Buffer buffer_, cells_;
    CityGrid grid_{};
    uint64_t placed_ = 0;
    Pipeline cast_ = graphics({.vertex = "15_terrain_water/city.vert", .cull = VK_CULL_MODE_NONE, .depth_clamp = true});
    Pipeline draw_shadowed_ = graphics({.vertex = "15_terrain_water/city.vert",
                                        .fragment = "15_terrain_water/city.frag",
                                        .macros = shadowed_by_houses()});
    Pipeline draw_ = graphics({.vertex = "15_terrain_water/city.vert", .fragment = "15_terrain_water/city.frag"});
};

}  // namespace lightwalk
