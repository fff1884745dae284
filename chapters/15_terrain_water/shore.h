// Shore world: terrain, a city, objects and water under a sky.
#pragma once
#include "05_shadow_maps/casting.h"
#include "05_shadow_maps/lit_scene.h"
#include "05_shadow_maps/rays.h"
#include "10_atmosphere/height_fog.h"
#include "10_atmosphere/planet.h"
#include "14_environment/probe.h"
#include "15_terrain_water/city.h"
#include "15_terrain_water/land.h"
#include "15_terrain_water/sun_shadow.h"
#include "15_terrain_water/transparency.h"
#include "15_terrain_water/water.h"
#include "common/app/world.h"

namespace lightwalk {

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

struct Shore : World {
    explicit Shore(Module& owner);

    Atmosphere atmosphere{*this, "atmosphere"};
    Planet sky{*this, "sky", atmosphere};
    Ground ground{*this, "ground"};
    Land land{*this, "land", ground, atmosphere};
    City city{*this, "city", ground, atmosphere};
    SunShadow sun_shadow{*this, "sun_shadow", atmosphere};
    LitScene objects{*this, "objects"};
    ImageLight light{*this, "environment"};
    SceneProbe probe{*this, "probe"};
    Water water{*this, "water", light};
    ReflectedRays reflected{*this, "reflected", ground, land, city, atmosphere};
    Transparency transparency{*this, "transparency"};
    HeightFog fog{*this, "fog"};

    Drawings drawings() override { return {land, city, objects, sky, water, atmosphere, fog}; }
    std::vector<std::pair<std::string, std::string>> look() const override { return {{"bloom.method", "none"}}; }

  protected:
    void record(Frame& frame) override;
    void record_view(Frame& frame, const View& view) override;
    void draw_view(Frame& frame, const View& view, Canvas& canvas) override;
};

}  // namespace lightwalk
