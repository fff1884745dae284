// Terrain drawing: the ground of a height map, with textures, shadows and the light of an atmosphere.
#pragma once
#include <map>
#include <nlohmann/json_fwd.hpp>

#include "10_atmosphere/atmosphere.h"
#include "11_fractals/ring_grid.h"
#include "15_terrain_water/ground.h"
#include "15_terrain_water/sun_shadow.h"
#include "common/app/chapter.h"
#include "common/app/drawing.h"
#include "common/gpu/gpu.h"

namespace lightwalk {

/// Arrays of four layers (grass, forest, rock, snow) that tile, RGBA8 with all levels. `materials`: the square root of the
/// albedo, and the height of the surface (0 to 1). `bumps`: slopes along u and v in r and g, 0.5 is level, 1 a height of 1
/// in 1/32 of the tile. Rock is the photograph of a bark, turned; the others are noise.
void make_ground_textures(Gpu& gpu, Image& materials, Image& bumps);

/// Drawn before objects on it or behind it. All methods find the same result, the distance to the ground in each
/// pixel; one pass shades it.
struct Land : Drawing, SunReceiver {
    Land(Module& owner, std::string name, Ground& ground, const Atmosphere& atmosphere);

    Choice method{*this,
                  "method",
                  {"grid", "rings", "chunks", "rays"},
                  "chunks",
                  "Geometry of the ground: one grid; rings around the camera; chunks whose level follows the error on "
                  "the screen; rays through every pixel (the reference)"};
    Knob<int> grid_level{*this, "grid_level", 2, {0, 7}, "Cells of the grid: 2^grid_level samples (method grid)"};
    Knob<int> ring_cells{
        *this, "ring_cells", 128, {8, 1024}, "Cells along a side of a ring; rounded to a multiple of 4"};
    Knob<float> error_px{*this,
                         "error_px",
                         1.5f,
                         {0.05f, 64.0f},
                         "Maximum error of chunks: the distance between the ground and each point drawn, in pixels at "
                         "that point",
                         "px"};
    Choice blend{*this,
                 "blend",
                 {"smooth", "height_aware"},
                 "height_aware",
                 "Transition between textures: their weights, or who stands out at this place"};
    Knob<float> softness{*this,
                         "softness",
                         0.25f,
                         {0.01f, 2.0f},
                         "Height over which one texture fades into another (blend height_aware)"};
    Choice shadow{
        *this, "shadow", {"none", "marched"}, "marched", "Shadow of the ground on itself: none, or a ray to the sun"};
    Knob<int> shadow_steps{*this, "shadow_steps", 48, {1, 1024}, "Number of steps of a shadow ray"};
    Knob<float> snow_m{*this, "snow_m", 2000.0f, {-1e4f, 1e4f}, "Snow line: height where snow begins on level ground",
                       "m"};
    Knob<float> forest{*this, "forest", 0.6f, {0.0f, 1.0f}, "Share of the ground that forest covers"};
    Knob<float> rock_deg{*this, "rock_deg", 34.0f, {0.0f, 90.0f}, "Slope from which rock shows", "degrees"};
    Knob<glm::vec3> grass_tint{*this,
                               "grass_tint",
                               glm::vec3(1.0f),
                               {glm::vec3(0.0f), glm::vec3(4.0f)},
                               "Scale factor for the albedo of grass"};
    Knob<glm::vec3> forest_tint{*this,
                                "forest_tint",
                                glm::vec3(1.0f),
                                {glm::vec3(0.0f), glm::vec3(4.0f)},
                                "Scale factor for the albedo of forest"};
    Knob<glm::vec3> rock_tint{
        *this, "rock_tint", glm::vec3(1.0f), {glm::vec3(0.0f), glm::vec3(4.0f)}, "Scale factor for the albedo of rock"};
    Knob<float> strata{*this, "strata", 0.0f, {0.0f, 1.0f}, "Contrast of the beds of rock that show in walls"};
    Knob<float> bumps{*this, "bumps", 1.0f, {0.0f, 8.0f}, "Strength of the bumps of textures"};
    Choice show{*this,
                "show",
                {"picture", "normals", "levels"},
                "picture",
                "Image shown: the ground, its normals, or its chunks by level"};

    void prepare(Gpu& gpu, Scene& loaded) override;
    void update(Frame& frame) override { ground_.record(frame, !method.is("rings") && !method.is("rays")); }
    const Drawing* sun_source() const override { return &atmosphere_; }
    std::vector<const Module*> dependencies() const override { return {this, &ground_, &atmosphere_}; }
    void draw(Frame& frame, const View& view, Canvas& canvas) override;

    /// Of the view drawn last: metres along the view, R32F, 0 where there is no ground.
    const Image& found() const { return *found_last_; }
    /// Triangles submitted for the last view; with method chunks those of the previous frame, once `count` is read
    /// back. Rays: 0.
    uint64_t triangles() const;
    bool count = false;

    /// For passes that include 15_terrain_water/land_light.glsl.
    void bind(Pass& pass) const override;

  private:
    struct PerView {
        Image found;
        Buffer list, draws;
    };
    void draw_chunks(Frame& frame, const View& view, Canvas& canvas, PerView& kept);
    void draw_rings(Frame& frame, const View& view, Canvas& canvas, const PerView& kept);
    void draw_rays(Frame& frame, const View& view, Canvas& canvas, const PerView& kept);
    void shade(Frame& frame, const View& view, Canvas& canvas, const PerView& kept);
    void cull(Frame& frame, const View& view, PerView& kept);
    Ground& ground_;
    const Atmosphere& atmosphere_;
    std::map<uint32_t, PerView> views_;
    const Image* found_last_ = nullptr;
    RingGrid rings_;
    Buffer chunk_indices_, none_;
    uint32_t ring_count_ = 0;
    ReadBack counted_;
    Image materials_, bumps_;
    Pipeline cull_ = compute({.shader = "15_terrain_water/cull_chunks.comp"});
    Pipeline chunk_ = graphics({.vertex = "15_terrain_water/land_chunks.vert",
                                .fragment = "15_terrain_water/land_found.frag",
                                .cull = VK_CULL_MODE_NONE});
    Pipeline ring_ = graphics({.vertex = "15_terrain_water/land_rings.vert",
                               .fragment = "15_terrain_water/land_found.frag",
                               .cull = VK_CULL_MODE_NONE});
    Pipeline ray_ = graphics(
        {.vertex = "06_deferred/whole.vert", .fragment = "15_terrain_water/land_rays.frag", .cull = VK_CULL_MODE_NONE});
    Pipeline shade_ = compute({.shader = "15_terrain_water/land_shade.comp"});
    Pipeline shade_shadowed_ = compute({.shader = "15_terrain_water/land_shade.comp", .macros = shadowed_by_houses()});
};

/// Renders the chapter as it is set and by rays, and adds to `error`: screen_error_px, how far the surface lies from the
/// rays' along its normal, in pixels, on average over pixels in which both find ground; screen_error_p99_px, its 99th
/// percentile; misjudged, the share of pixels in which one of the two finds ground; and triangles.
void measure_land(Chapter& chapter, Land& land, Gpu& gpu, glm::uvec2 size, nlohmann::json& error);

}  // namespace lightwalk
