// Chapter 06: what is seen is written down first, and lit afterwards.
#include <fmt/core.h>

#include <nlohmann/json.hpp>

#include "01_obj/model_chapter.h"
#include "03_attenuation/scattered_lights.h"
#include "05_shadow_maps/shadow.h"
#include "06_deferred/deferred_lights.h"
#include "06_deferred/screens.h"
#include "06_deferred/surfaces.h"
#include "common/app/read_picture.h"
#include "common/window/run.h"

using namespace lightwalk;

struct Deferred : ModelChapter {
    Maps maps{*this, "maps"};
    Lights lights{*this, "lights"};
    Shadow shadow{*this, "shadow"};
    GBuffer gbuffer{*this, "gbuffer"};
    Screens screens{*this, "screens"};
    Choice cull{
        *this,
        "cull",
        {"fixed", "geometry", "none", "left_out"},
        "fixed",
        "what leaves triangles that face away out of the G-buffer; left_out: those alone that geometry leaves out"};
    Knob<int> scattered{*this, "lights", 0, {0, 1000000}, "how many more lights are scattered over the scene"};
    Knob<int> overdraw{*this, "overdraw", 1, {1, 64}, "how often every surface is drawn"};
    Knob<bool> prepass{*this, "prepass", false, "depth alone first, so that each pixel is drawn once"};

    const SurfacePasses by;
    DeferredLights deferred_lights;
    Bounds lit;  ///< where lights are scattered: where the scene was when it was loaded

    // Into a map of shadows: what textures cut holes into is drawn with its maps.
    Shadow::Casters casters() const {
        return {{maps}, [this](Raster& pass, const DrawList& all) {
                    const auto has_holes = [this](const DrawItem& item) { return maps.has_holes(item); };
                    pass.use(shadow.solid).draw(all.where(std::not_fn(has_holes)));
                    maps.draw(pass, scene, all.where(has_holes), by.caster, by.caster);
                }};
    }

    Deferred() { gbuffer.method.alone = true; }  // --method is about G-buffers here
    std::string default_scene() const override { return "scenes/hundred_lamps.json"; }
    std::string load_key() const override { return maps.load_key() + screens.width.text(); }
    bool animated() const override { return maps.animated() || scene.moves() || screens.count() > 0; }
    void prepare(Gpu& gpu) override {
        maps.prepare(gpu, scene);
        screens.prepare(gpu, scene);
        shadow.forget();
        lit = scene.bounds;
    }

    // [frame]
    void frame(Frame& frame) override {
        set_view(frame);
        const std::vector<Batch> surfaces = screens.batches(scene);
        const auto draw = [&](const Pipeline& loaded, const Pipeline& displaced) {
            return [&](Raster& pass) {
                for (int i = 0; i < overdraw; ++i) maps.draw(pass, scene, surfaces, loaded, displaced);
            };
        };
        const auto draw_with = [&](const SurfacePipelines& both) { return draw(both.loaded, both.displaced); };

        // 1. The lights of chapter 03 with the shadows of chapter 05, and what other cameras see by them.
        lights.update(frame, scene, all_lights(frame.seed));
        shadow.record(frame, scene, lights, camera, casters());
        screens.record(frame, scene, {maps, lights, shadow}, draw_with(by.screen));

        // 2. Depth alone, where somebody asks for it.
        const bool forwards = gbuffer.is_forward() || gbuffer.shows_loss();
        const bool depth_first = prepass || (forwards && lights.needs_depth());
        if (depth_first) frame.raster("depth", {.depth = frame.depth, .with = {maps, screens}}, draw_with(by.depth));
        const Attachment depth_buffer = depth_first ? keep(frame.depth) : Attachment(frame.depth);
        gbuffer.begin(frame);

        if (forwards) {
            // 3. Every surface, lit where it is drawn;
            lights.record(frame, scene, camera);
            frame.raster("forward",
                         {.color = {clear(frame.hdr, gbuffer.shows_loss() ? glm::vec4(-1.0f)
                                                                          : glm::vec4(scene.file.background, 0.0f))},
                          .depth = depth_buffer,
                          .with = {maps, lights, shadow, gbuffer, screens}},
                         draw_with(gbuffer.shows_loss() ? by.lost : by.forward));
        } else {
            // 3. or what it is, for each pixel; then light on what is seen in the end; then what glows by itself.
            frame.raster("gbuffer",
                         {.color = gbuffer.targets(), .depth = depth_buffer, .with = {maps, gbuffer, screens}},
                         cull.is("geometry")   ? draw(by.write_culled, by.write_culled)
                         : cull.is("left_out") ? draw(by.write_left_out, by.write_left_out)
                                               : draw_with(cull.is("none") ? by.write_all : by.write));
            gbuffer.written();
            deferred_lights.record(frame, scene, camera, gbuffer, lights, {lights, shadow, gbuffer});
            if (const auto glows = glowing(scene, surfaces); !glows.empty())
                frame.raster("glow",
                             {.color = {keep(frame.hdr)}, .depth = read_only(frame.depth), .with = {maps, screens}},
                             [&](Raster& pass) { maps.draw(pass, scene, glows, by.glow.loaded, by.glow.displaced); });
            if (!gbuffer.show.is("picture")) deferred_lights.show(frame, gbuffer);
        }

        // 4. Linear light to the codes a screen expects.
        encode_srgb(frame);
    }
    // [/frame]

    std::vector<Light> all_lights(unsigned seed) const {
        std::vector<Light> all = scene.file.lights;
        const std::vector<Light> more = scatter_lights(lit, scattered, seed);
        all.insert(all.end(), more.begin(), more.end());
        return all;
    }

    // For the study: what the G-buffer takes, and what it loses of normals and positions in the mean over the picture.
    void measure(Gpu& gpu, glm::uvec2 size, nlohmann::json& error) override {
        gbuffer.show.set("loss");
        Frame own(gpu);
        render(*this, own, {size, 0.0f, 0, {}});
        const glm::vec2 lost = mean_loss(read_linear(gpu, own.hdr));
        error["bytes_per_pixel"] = gbuffer.bytes_per_pixel();
        error["normal_deg"] = lost.x;
        error["position_mm"] = lost.y;
    }

    std::vector<std::string> status() const override {
        return {fmt::format("{} lights; {} bytes a pixel beside depth", lights.buffer().lights().size(),
                            gbuffer.bytes_per_pixel())};
    }
};

CHAPTER(Deferred)
