#include "19_ambiance/worlds.h"

#include "04_surface_maps/surfaces.h"
#include "05_shadow_maps/lit_stage.h"
#include "09_post_effects/through_lens.h"
#include "10_atmosphere/islands.h"
#include "11_fractals/fractal.h"
#include "11_fractals/landscape.h"
#include "12_skin/portrait.h"
#include "13_mlaa/outlines.h"
#include "14_environment/surroundings.h"
#include "15_terrain_water/shore.h"
#include "16_volume/volume_world.h"
#include "17_planets/solar_system.h"
#include "18_playground/workbench.h"
#include "19_ambiance/climbing_lights.h"
#include "19_ambiance/descent.h"
#include "19_ambiance/street.h"

namespace lightwalk {
namespace {

template <class Shown>
std::unique_ptr<World> make(Module& owner, Music*) {
    return std::make_unique<Shown>(owner);
}

std::unique_ptr<World> make_surroundings(Module& owner, Music* heard) {
    return std::make_unique<Surroundings>(owner, heard);
}

}  // namespace

const std::map<std::string, MakeWorld>& film_worlds() {
    static const std::map<std::string, MakeWorld> all{
        {"planets", make<SolarSystem>}, {"landscape", make<Landscape>},      {"water", make<Shore>},
        {"volume", make<VolumeWorld>},  {"julia", make<JuliaSet>},           {"head", make<Portrait>},
        {"outlines", make<Outlines>},   {"surroundings", make_surroundings}, {"lights", make<ClimbingLights>},
        {"street", make<Street>},       {"workbench", make<Workbench>},      {"stage", make<LitStage>},
        {"islands", make<Islands>},     {"fractal", make<Fractal>},          {"surfaces", make<Surfaces>},
        {"lens", make<ThroughLens>},    {"descent", make<Descent>}};
    return all;
}

}  // namespace lightwalk
