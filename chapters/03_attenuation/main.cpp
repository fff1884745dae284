// Chapter 03: point and spot lights, and light culling.
#include <cstring>
#include <glm/gtc/packing.hpp>
#include <nlohmann/json.hpp>

#include "01_obj/model_chapter.h"
#include "03_attenuation/lights.h"
#include "03_attenuation/scattered_lights.h"
#include "common/window/run.h"

using namespace lightwalk;

namespace {

// Mean number of lights per pixel, from alpha of `hdr` with `show` at light_count; 0 in the background.
// Half floats round counts above 2,048.
double mean_light_count(Gpu& gpu, const Image& hdr) {
    const std::vector<std::byte> texels = gpu.read_back(hdr);
    double sum = 0;
    for (size_t i = 0; i < texels.size(); i += 8) {
        uint16_t alpha = 0;
        std::memcpy(&alpha, texels.data() + i + 6, 2);
        sum += static_cast<double>(glm::unpackHalf1x16(alpha));
    }
    return sum / (static_cast<double>(texels.size()) / 8);
}

}  // namespace

struct Attenuation : ModelChapter {
    Lights lights{*this, "lights"};
    ScatteredLights scattered{*this};
    Knob<bool> moving{*this, "moving", false, "Animation of the point and spot lights"};
    Choice show{*this,
                "show",
                {"picture", "light_count"},
                "picture",
                "View: the picture, or the number of lights computed for each pixel (light_count)"};

    Pipeline depth = graphics({.vertex = "03_attenuation/surface.vert"});
    Pipeline shade = graphics({.vertex = "03_attenuation/surface.vert", .fragment = "03_attenuation/shade.frag"});

    std::string default_scene() const override { return "scenes/night.json"; }
    bool animated() const override { return moving || ModelChapter::animated(); }

    // [frame]
    void frame(Frame& frame) override {
        const View view = set_view(frame);

        // 1. Scene and scattered lights into a buffer, if any has changed.
        lights.update(frame, scene, scattered.all(frame.seed, moving ? std::optional(frame.time_s) : std::nullopt));

        // 2. Depth prepass, so that each pixel is lit once and tiles know their depth range.
        frame.raster("depth", {.depth = frame.depth}, [&](Raster& pass) { pass.use(depth).draw(scene); });

        // 3. Light lists: a bit for each pair of light and cell. Cells are tiles of the screen, or clusters of tile and
        // depth.
        lights.set_cells(frame, scene, view);
        LightGrid& grid = lights.grid;
        if (lights.method.is("tiled"))
            frame.compute("cull_tiles", {.reads = {frame.depth}, .writes = {grid.masks, grid.groups}, .with = {lights}},
                          [&](Compute& pass) {
                              pass.use(grid.cull_tiles).set("depth", frame.depth, nearest_clamp);
                              pass.dispatch({grid.view.tiles, 1});
                          });
        else if (lights.method.is("clustered") && grid.group_count() > 0)
            frame.compute("cull_lights", {.writes = {grid.masks, grid.groups}, .with = {lights}}, [&](Compute& pass) {
                pass.use(grid.cull_clusters).dispatch_threads(glm::uvec2(grid.cell_count(), grid.group_count()));
            });

        // 4. Shading with the lights of each pixel's cell, in linear HDR.
        frame.raster("shade",
                     {.color = {clear(frame.hdr, glm::vec4(scene.file.background, 0.0f))},
                      .depth = keep(frame.depth),
                      .with = {lights}},
                     [&](Raster& pass) { pass.use(shade).set("ambient", scene.file.ambient).draw(scene); });

        // 5. Linear light, encoded as sRGB.
        encode_srgb(frame);
    }
    // [/frame]

    // Study value: mean number of lights per pixel.
    void measure(Gpu& gpu, glm::uvec2 size, nlohmann::json& error) override {
        show.set("light_count");
        Frame counting(gpu);
        render(*this, counting, {size, 0, 0, {}});
        error["lights_per_pixel"] = mean_light_count(gpu, counting.hdr);
    }
};

CHAPTER(Attenuation)
