// Reflected ray module: reflections in water, found by rays through ground, houses and objects.
#pragma once
#include "05_shadow_maps/casting.h"
#include "05_shadow_maps/rays.h"
#include "15_terrain_water/city.h"
#include "15_terrain_water/land.h"
#include "15_terrain_water/water.h"

namespace lightwalk {

// [reflected_rays]
/// The reference of the water's reflections: a ray for each pixel. Ground and houses are lit by the functions that light
/// them in the picture; objects by their diffuse colour alone, and transparent ones are not met. Give it to a Water:
///
///     water.tracer = &reflected;
struct ReflectedRays : Module, WaterRays {
    ReflectedRays(Module& owner, std::string name, const Ground& ground, const Land& land, City& city,
                  const Atmosphere& atmosphere)
        : Module(owner, std::move(name), "reflected_rays"),
          ground_(ground),
          land_(land),
          city_(city),
          atmosphere_(atmosphere) {}

    SceneRays objects{*this, "objects"};

    void find_casters(const Drawings& drawings) override { maps_ = Casting(drawings).maps(); }
    void prepare(Gpu& gpu, Scene& scene) override;
    void record(Frame& frame, const View& view, const Image& rays, const Image& met) override;
    // [/reflected_rays]

  private:
    const Ground& ground_;
    const Land& land_;
    City& city_;
    const Atmosphere& atmosphere_;
    const Scene* scene_ = nullptr;
    const Maps* maps_ = nullptr;  ///< those that cut holes into the scene's objects
    Buffer colors_, none_, none_cells_;
    Image no_ground_;
    bool has_colors_ = false;
    Pipeline trace_ = compute({.shader = "15_terrain_water/reflected_rays.comp"});
    Pipeline trace_shadowed_ =
        compute({.shader = "15_terrain_water/reflected_rays.comp", .macros = shadowed_by_houses()});
};

}  // namespace lightwalk
