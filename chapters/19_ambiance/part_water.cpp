// Chapter 15's ground, city and water under chapter 10's sky.
#include "05_shadow_maps/lit_scene.h"
#include "10_atmosphere/height_fog.h"
#include "10_atmosphere/planet.h"
#include "14_environment/probe.h"
#include "15_terrain_water/city.h"
#include "15_terrain_water/height_map.h"
#include "15_terrain_water/land.h"
#include "15_terrain_water/sun_shadow.h"
#include "15_terrain_water/transparency.h"
#include "15_terrain_water/water.h"
#include "19_ambiance/part.h"

namespace lightwalk {
namespace {

struct WaterPart : FilmPart {
    WaterPart(const FilmScene& scene, Music& music) : FilmPart(scene, music) {
        sky.map.change_default("plain");
        fog.method.change_default("none");
        light.method.change_default("mirror");
        light.radiance_alone = true;
        land.shadowed_by = city.shadowed_by = &sun_shadow;
        probe.update.change_default("moved");
        probe.distant = true;
    }
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
    Transparency transparency{*this, "transparency"};
    HeightFog fog{*this, "fog"};

    Model load_model(const std::filesystem::path& file) override {
        if (!is_height_map_file(file)) return FilmPart::load_model(file);
        Model none;  // the module ground itself reads the file
        none.materials.emplace_back();
        return none;
    }

    void draw_light(Frame& frame, const Camera& camera) override {
        const View view = look(frame, camera);
        scene_.set_sun(atmosphere.sun());
        Drawing& air = atmosphere.without_disc();  // the water has the sun's glitter itself
        ground.record(frame, false);
        sun_shadow.record(frame, view, scene_, city);
        light.record(frame, scene_);
        if (water.sees_surroundings(view)) probe.record(frame, scene_, light, {sky, air});
        water.reflect(frame, view, {land, city, objects}, {sky, air, fog});
        Canvas canvas(frame.hdr, frame.depth);
        canvas.mixed_by(&transparency);
        draw(frame, view, canvas, {land, city, objects, sky, water, atmosphere, fog});
    }
};

}  // namespace

std::unique_ptr<FilmPart> make_water(const FilmScene& scene, Music& music) {
    return std::make_unique<WaterPart>(scene, music);
}

}  // namespace lightwalk
