// Chapter 03: point and spot lights, and how not to compute those that do not reach.
#include <nlohmann/json.hpp>

#include "01_obj/model_chapter.h"
#include "03_attenuation/light_count.h"
#include "03_attenuation/light_field.h"
#include "03_attenuation/light_grid.h"
#include "03_attenuation/need.h"
#include "03_attenuation/object_lights.h"

using namespace lightwalk;

struct Attenuation : ModelChapter {
    // [method]
    Choice method{"method",
                  {"every_light", "per_object", "tiled", "clustered"},
                  "clustered",
                  "which lights a pixel computes: all, or those that may reach its object, tile or cluster"};
    Choice falloff{"falloff",
                   {"range_fade", "inverse_square_window", "inverse_square"},
                   "inverse_square_window",
                   "how light weakens with distance; inverse_square never ends"};
    // [/method]
    Knob<float> fade_k{"fade_k", 1.0f, {0.0f, 100.0f}, "k of range_fade", "1/m²"};
    Knob<float> threshold{
        "threshold", 0.004f, {1e-6f, 1.0f}, "radiance at which culling takes inverse_square to have ended"};
    Knob<int> lights{"lights", 0, {0, 1000000}, "how many more lights are scattered over the scene"};
    Knob<bool> moving{"moving", false, "point and spot lights move"};
    Knob<int> slices{"slices", 24, {1, 256}, "how many clusters a tile is cut into"};
    Choice show{"show", {"picture", "light_count"}, "picture", "the picture, or how many lights each pixel computed"};

    Pipeline depth = graphics({.vertex = "03_attenuation/surface.vert"});
    Pipeline shade = graphics({.vertex = "03_attenuation/surface.vert", .fragment = "03_attenuation/shade.frag"});
    LightBuffer light_buffer;
    ObjectLights object_lights;
    LightGrid grid;

    std::string default_scene() const override { return "scenes/night.json"; }
    bool animated() const override { return moving; }
    void prepare(Gpu&) override { object_lights.forget(); }

    // The scene's lights and the scattered ones, where they are at this time.
    std::vector<Light> lights_at(float time_s, unsigned seed) const {
        std::vector<Light> all = scene.file.lights;
        const std::vector<Light> more = scatter_lights(scene.bounds, lights, seed);
        all.insert(all.end(), more.begin(), more.end());
        if (moving) move_lights(all, time_s);
        return all;
    }

    std::vector<std::string> choose(double budget, glm::uvec2 size) override {
        const CullingNeed need =
            measure_culling(scene, camera, size, lights_at(0, 0), slices, falloff.is("inverse_square"));
        const CullingChoice& choice = cheapest_within(need, budget);
        method.set(choice.method);
        if (choice.threshold > 0) threshold.value = choice.threshold;
        return explain(need, choice, budget);
    }

    // [frame]
    void frame(Frame& frame) override {
        set_view(frame);
        const float ends_at = falloff.is("inverse_square") ? threshold : 0.0f;
        const bool cells = method.is("tiled") || method.is("clustered");

        // 1. The lights and each object's list of them, where something has changed.
        light_buffer.update(frame.gpu, lights_at(frame.time_s, frame.seed));
        if (method.is("per_object")) object_lights.update(frame.gpu, scene, light_buffer, ends_at);

        // 2. Depth alone, so that each pixel is lit once, and tiles know what they hold.
        frame.raster("depth", {.depth = frame.depth}, [&](Raster& pass) { pass.use(depth).draw(scene); });

        // 3. Lights into cells.
        grid.set_view(frame, camera, scene.bounds,
                      method.is("tiled") ? LightGrid::Cells::tiles : LightGrid::Cells::clusters, slices,
                      light_buffer.lights().size(), ends_at);
        if (cells) grid.record(frame, light_buffer.buffer);

        // 4. Every surface, in linear HDR.
        RasterTargets targets{.color = {clear(frame.hdr, glm::vec4(scene.file.background, 0.0f))},
                              .depth = keep(frame.depth)};
        if (cells) targets.reads = {grid.masks, grid.groups};
        frame.raster("shade", targets, [&](Raster& pass) {
            pass.use(shade).set("lights", light_buffer.buffer).set("ambient", scene.file.ambient);
            if (method.is("per_object"))
                pass.set("object_ends", object_lights.ends).set("object_lights", object_lights.lights);
            if (cells) pass.set("masks", grid.masks).set("groups", grid.groups);
            pass.draw(scene);
        });

        // 5. Linear light to the codes a screen expects.
        encode_srgb(frame);
    }
    // [/frame]

    // For the study: how many lights a pixel has computed, in the mean over the picture.
    void measure(Gpu& gpu, glm::uvec2 size, nlohmann::json& error) override {
        show.set("light_count");
        Frame counting(gpu);
        render(*this, counting, size, 0, 0);
        error["lights_per_pixel"] = mean_light_count(gpu, counting.hdr);
    }

    std::vector<std::string> status() const override {
        return {std::to_string(light_buffer.lights().size()) + " lights, packed " +
                std::to_string(light_buffer.rebuilds) + "×"};
    }
};

CHAPTER(Attenuation)
