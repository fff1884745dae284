// Chapter 15: terrain, water and transparent surfaces under a sky.
#include <nlohmann/json.hpp>

#include "01_obj/model_chapter.h"
#include "05_shadow_maps/lit_scene.h"
#include "08_bloom/bloom.h"
#include "09_post_effects/post.h"
#include "10_atmosphere/height_fog.h"
#include "10_atmosphere/planet.h"
#include "14_environment/probe.h"
#include "15_terrain_water/city.h"
#include "15_terrain_water/land_error.h"
#include "15_terrain_water/reflected_rays.h"
#include "15_terrain_water/sun_shadow.h"
#include "15_terrain_water/transparency.h"
#include "15_terrain_water/water.h"
#include "common/window/run.h"

using namespace lightwalk;

struct TerrainWater : ModelChapter {
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
    Bloom bloom{*this, "bloom"};
    Post post{*this, "post"};

    TerrainWater() {
        land.method.alone = true;  // --method is about the ground here
        sky.map.change_default("plain");
        fog.method.change_default("none");
        bloom.method.change_default("none");
        water.method.change_default("none");
        light.method.change_default("mirror");
        light.radiance_alone = true;  // water looks along single directions
        land.shadowed_by = city.shadowed_by = &sun_shadow;
        water.tracer = &reflected;
        reflected.maps = &objects.maps;
        probe.update.change_default("moved");
        probe.distant = true;
        probe.in_use = light.in_use = [this] { return !water.method.is("none"); };
    }
    std::string default_scene() const override { return "scenes/valley.json"; }

    Model load_model(const std::filesystem::path& file) override {
        if (!is_height_map_file(file)) return ModelChapter::load_model(file);
        Model none;  // the module ground itself reads the file
        none.materials.emplace_back();
        return none;
    }

    // For the study: where the ground lies, against rays.
    void measure(Gpu& gpu, glm::uvec2 size, nlohmann::json& error) override {
        if (ground.exists()) measure_land(*this, land, gpu, size, error);
    }

    // [frame]
    void frame(Frame& frame) override {
        const View view = set_view(frame);
        scene.set_sun(atmosphere.sun());

        // 1. What houses leave of the sun; the sky in a cube or the mirror image, where there is water to show it.
        ground.record(frame, false);
        sun_shadow.record(frame, view, scene, city);
        if (!water.method.is("none")) {
            Drawing& air = atmosphere.without_disc();  // the water has the sun's glitter itself
            light.record(frame, scene);
            if (water.sees_surroundings(view)) probe.record(frame, scene, light, {sky, air});
            water.reflect(frame, view, {land, city, objects}, {sky, air, fog});
        }

        // 2. Ground and what stands on it, the planet and the stars behind, the water, and the air and the fog before all of
        //    it; then what is transparent.
        Canvas canvas(frame.hdr, frame.depth);
        canvas.mixed_by(&transparency);
        draw(frame, view, canvas, {land, city, objects, sky, water, atmosphere, fog});

        // 3. Chapter 08's bloom, chapter 09's tones, and the codes a screen expects.
        bloom.record(frame, frame.hdr);
        post.record(frame, frame.hdr);
        encode_srgb(frame);
    }
    // [/frame]
};

CHAPTER(TerrainWater)
