// Chapter 03: point and spot lights, and the culling of those that do not reach a pixel.
#include <fmt/core.h>

#include <nlohmann/json.hpp>

#include "01_obj/model_chapter.h"
#include "03_attenuation/light_count.h"
#include "03_attenuation/lights.h"
#include "03_attenuation/scattered_lights.h"
#include "common/window/run.h"

using namespace lightwalk;

struct Attenuation : ModelChapter {
    Lights lights{*this, "lights"};
    Knob<int> scattered{*this, "lights", 0, {0, 1000000}, "Number of random lights added to those of the scene"};
    Knob<bool> moving{*this, "moving", false, "Animation of the point and spot lights"};
    Choice show{*this,
                "show",
                {"picture", "light_count"},
                "picture",
                "View: the picture, or the number of lights computed for each pixel (light_count)"};

    Pipeline depth = graphics({.vertex = "03_attenuation/surface.vert"});
    Pipeline shade = graphics({.vertex = "03_attenuation/surface.vert", .fragment = "03_attenuation/shade.frag"});

    Bounds lit;  ///< where lights are scattered: where the scene was when it was loaded

    std::string default_scene() const override { return "scenes/night.json"; }
    bool animated() const override { return moving || ModelChapter::animated(); }
    void prepare(Gpu&, Scene&) override { lit = scene.bounds; }

    // The scene's lights and the scattered ones, where they are at this time.
    std::vector<Light> lights_at(float time_s, unsigned seed) const {
        std::vector<Light> all = scene.file.lights;
        const std::vector<Light> more = scatter_lights(lit, scattered, seed);
        all.insert(all.end(), more.begin(), more.end());
        if (moving) move_lights(all, time_s);
        return all;
    }

    // [frame]
    void frame(Frame& frame) override {
        const View view = set_view(frame);

        // 1. The lights, if any has changed.
        lights.update(frame, scene, lights_at(frame.time_s, frame.seed));

        // 2. Depth alone, so that each pixel is lit once and tiles know their depth range.
        frame.raster("depth", {.depth = frame.depth}, [&](Raster& pass) { pass.use(depth).draw(scene); });

        // 3. Lights into cells.
        lights.record(frame, scene, view, frame.depth);

        // 4. Every surface, in linear HDR.
        frame.raster("shade",
                     {.color = {clear(frame.hdr, glm::vec4(scene.file.background, 0.0f))},
                      .depth = keep(frame.depth),
                      .with = {lights}},
                     [&](Raster& pass) { pass.use(shade).set("ambient", scene.file.ambient).draw(scene); });

        // 5. Linear light to the codes a screen expects.
        encode_srgb(frame);
    }
    // [/frame]

    // For the study: how many lights a pixel has computed, in the mean over the picture.
    void measure(Gpu& gpu, glm::uvec2 size, nlohmann::json& error) override {
        show.set("light_count");
        Frame counting(gpu);
        render(*this, counting, {size, 0, 0, {}});
        error["lights_per_pixel"] = mean_light_count(gpu, counting.hdr);
    }

    std::vector<std::string> status() const override {
        return {fmt::format("{} lights, packed {}×", lights.buffer().lights().size(), lights.buffer().rebuilds)};
    }
};

CHAPTER(Attenuation)
