#include <fmt/core.h>

#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/gtx/color_space.hpp>

#include "01_obj/camera_view.h"
#include "04_surface_maps/surface_scene.h"
#include "05_shadow_maps/lit_stage.h"
#include "06_deferred/many_lights.h"
#include "09_post_effects/depth_of_field.h"
#include "10_atmosphere/islands.h"
#include "10_atmosphere/planet.h"
#include "11_fractals/fractal.h"
#include "12_skin/head.h"
#include "13_mlaa/outlines.h"
#include "14_environment/surroundings.h"
#include "15_terrain_water/shore.h"
#include "16_volume/volume_world.h"
#include "17_planets/solar_system.h"
#include "18_playground/workbench.h"
#include "19_ambiance/part.h"
#include "common/app/knob_scope.h"

namespace lightwalk {
namespace {

// Endless terrain under chapter 10's air and in its fog.
struct Landscape : World {
    explicit Landscape(Module& owner) : World(owner) { terrain.own_sky = false; }
    Atmosphere atmosphere{*this, "atmosphere"};
    Planet sky{*this, "sky", atmosphere};
    HeightFog fog{*this, "fog"};
    Terrain terrain{*this, "terrain"};

    Drawings drawings() override { return {terrain, sky, atmosphere, fog}; }
    std::vector<std::pair<std::string, std::string>> look() const override { return {{"bloom.method", "none"}}; }
};

// Chapter 15's shore below a layer of clouds, for a camera that comes from orbit.
struct Descent : Shore {
    using Shore::Shore;
    CloudLayer clouds{*this, "clouds", atmosphere, sky};

    Drawings drawings() override {
        Drawings all = Shore::drawings();
        all.emplace_back(clouds);
        return all;
    }
};

// Many lights, of which some climb a figure.
struct ClimbingLights : ManyLights {
    using ManyLights::ManyLights;
    Knob<int> climbers{*this, "climbers", 0, {0, 100000}, "Number of lights that climb a figure, besides all others"};
    Knob<glm::vec3> foot{
        *this, "foot", glm::vec3(0.0f), {glm::vec3(-1e4f), glm::vec3(1e4f)}, "Place where the figure stands", "m"};
    Knob<float> figure_m{*this, "figure_m", 1.8f, {0.01f, 1000.0f}, "Height that the lights climb to", "m"};
    Knob<float> girth_m{*this, "girth_m", 0.5f, {0.01f, 1000.0f}, "Distance of the lights from its axis, at the foot",
                        "m"};
    bool animated() const override { return climbers > 0 || ManyLights::animated(); }

  protected:
    // Spirals with steps of the golden angle. Each light is born at the foot, and fades out at the top.
    LightList all_lights(const Frame& frame) override {
        const LightList others = ManyLights::all_lights(frame);
        std::vector<Light> all = *others;
        constexpr double golden = 0.6180339887498949;
        for (int i = 0; i < climbers; ++i) {
            const double speed = 0.12 + 0.1 * std::fmod(7 * golden * i, 1.0);  // of the height, in a second
            const double high = std::fmod(golden * i + speed * static_cast<double>(frame.time_s), 1.0);
            const double around = glm::two_pi<double>() * (std::fmod(3 * golden * i, 1.0) + 0.7 * high);
            const double wide = static_cast<double>(girth_m) * (1 - 0.45 * high), tall = static_cast<double>(figure_m);
            Light light{.kind = Light::Kind::point, .range_m = 0.15f * figure_m};
            light.position = foot.value + glm::vec3(wide * std::cos(around), tall * high, wide * std::sin(around));
            light.color = glm::rgbColor(glm::vec3(360 * std::fmod(5 * golden * i, 1.0), 0.95f, 1.0f));
            light.intensity = static_cast<float>(0.2 * std::min(1.0, 6 * std::min(high, 1 - high)));
            all.push_back(light);
        }
        return std::make_shared<const std::vector<Light>>(std::move(all));
    }
};

// Chapter 06's lights in upright strips, each drawn by another method.
struct Street : ManyLights {
    using ManyLights::ManyLights;

  protected:
    // Strips of equal width, each a part of the whole picture.
    void draw_view(Frame& frame, const View& view, Canvas& canvas) override {
        static const char* const methods[] = {"forward", "fat", "packed", "tiled"};
        for (uint32_t i = 0; i < 4; ++i) {
            const KnobScope method(objects.gbuffer.method, methods[i]);
            const uint32_t first = view.size.x * i / 4, end = std::max(view.size.x * (i + 1) / 4, first + 1);
            Crop crop = view.crop;
            crop.origin.x += first;
            View strip = view_of(view.camera, {end - first, view.size.y}, crop);
            strip.id = views_.of(view.id, i);
            colors_[i].ensure(frame.gpu.device, {.name = fmt::format("strip {}", i), .size = strip.size});
            depths_[i].ensure(
                frame.gpu.device,
                {.name = fmt::format("strip {} depth", i), .format = VK_FORMAT_D32_SFLOAT, .size = strip.size});
            Canvas own(colors_[i], depths_[i], canvas.background());
            draw(frame, strip, own, drawings());
        }
        const ImageView joined = canvas.color_overwritten();
        frame.compute("strips", {.reads = {colors_[0], colors_[1], colors_[2], colors_[3]}, .writes = {joined}},
                      [&](Compute& pass) {
                          pass.use(join_);
                          for (int i = 0; i < 4; ++i) pass.set(fmt::format("strip_{}", i), colors_[i], nearest_clamp);
                          pass.set("result", joined).dispatch_threads(view.size);
                      });
    }

  private:
    DerivedViews views_;
    Image colors_[4], depths_[4];
    Pipeline join_ = compute({.shader = "19_ambiance/strips.comp"});
};

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
