// Chapter 06: deferred shading, surfaces stored first and lit afterwards.
#include <algorithm>
#include <nlohmann/json.hpp>

#include "01_obj/model_chapter.h"
#include "06_deferred/many_lights.h"
#include "common/window/run.h"

using namespace lightwalk;

struct Deferred : ModelChapter {
    ManyLights world{*this};
    DeferredScene& objects = world.objects;
    SurfaceScene& surfaces = objects.surfaces;
    Maps& maps = objects.maps;
    Lights& lights = objects.lights;
    Shadow& shadow = objects.shadow;
    GBuffer& gbuffer = objects.gbuffer;
    Culling& culling = objects.culling;
    DeferredLights& deferred = objects.deferred;
    Choice cull{*this,
                "cull",
                {"fixed", "geometry", "none", "left_out"},
                "fixed",
                "Back-face culling in the G-buffer pass: by the device (fixed), by a geometry shader (geometry), none, "
                "or only the triangles that geometry removes (left_out)"};
    Knob<int> overdraw{*this, "overdraw", 1, {1, 64}, "Overdraw: number of times each surface is drawn"};
    Knob<bool> prepass{*this, "prepass", false, "Depth prepass, so that each pixel is shaded or written once"};
    Choice order{
        *this,
        "order",
        {"file", "front_to_back", "random", "back_to_front"},
        "file",
        "Order in which opaque objects are drawn: the scene file's, with equal meshes in one call (file); or one "
        "by one, sorted by distance or at random, unless objects are culled"};

    Knob<float> above_m{*this,
                        "above_m",
                        0.0f,
                        {0.0f, 1000.0f},
                        "Height above the camera from which the objects that were drawn are shown; 0: the picture",
                        "m"};

    // G-buffer pipelines without back-face culling, or with culling by a geometry shader.
    SurfacePipelines write_all{{.fragment = "06_deferred/write.frag", .cull = VK_CULL_MODE_NONE}};
    SurfacePipelines write_culled{
        {.geometry = "06_deferred/cull.geom", .fragment = "06_deferred/write.frag", .cull = VK_CULL_MODE_NONE}};
    SurfacePipelines write_left_out{{.geometry = "06_deferred/cull.geom",
                                     .fragment = "06_deferred/write.frag",
                                     .cull = VK_CULL_MODE_NONE,
                                     .macros = {{"LEFT_OUT", "1"}}}};
    // Emission behind the same geometry shader, since its depths may differ in the last bit.
    SurfacePipelines emission_culled{{.geometry = "06_deferred/cull.geom",
                                      .fragment = "06_deferred/emission.frag",
                                      .cull = VK_CULL_MODE_NONE,
                                      .depth_write = false}};

    Deferred() {
        gbuffer.method.preferred = true;  // --method is about G-buffers here
    }
    std::string default_scene() const override { return "scenes/hundred_lamps.json"; }

    // [frame]
    void frame(Frame& frame) override {
        const View view = set_view(frame, world);
        Canvas canvas(frame.hdr, frame.depth, glm::vec4(scene.file.background, 0.0f));
        const bool forward = gbuffer.is_forward() || gbuffer.shows_loss(), ggx = maps.surface.model.is("ggx");

        // 1. Lights in a buffer (chapter 03), pictures of the scene's screens, shadow maps (chapter 05).
        world.prepare_view(frame, view);
        objects.lit.record_shadows(frame, view);
        const std::vector<Batch> all = surfaces.opaque_batches(), stored = objects.batches_by_stored(true);

        // 2. Culling: objects that may be visible. Bounds are valid for meshes as loaded; a geometry shader needs all
        // instances. culling.passes() records a pass a second time for objects that are no longer hidden.
        const bool by_device = cull.is("fixed") || cull.is("none");
        culling.begin(frame, scene, view, maps.mesh.is("loaded") && by_device ? all : std::vector<Batch>());

        // 3. Depth prepass, so that each pixel is written or lit once.
        if (prepass)
            culling.passes(frame, frame.depth, [&] {
                frame.raster("depth", {.depth = canvas.depth_target(), .with = objects.with({maps})},
                             objects.by(surfaces.depth_pipelines(), often(forward ? all : stored)));
            });

        gbuffer.begin(frame, view, frame.depth);
        if (forward) {
            // 4. Forward shading, for comparison.
            objects.draw_forward(frame, view, canvas, often(all));
        } else {
            // 4. G-buffer: surfaces without light.
            culling.passes(frame, frame.depth, [&] {
                frame.raster("gbuffer",
                             {.color = gbuffer.targets(culling.completes()),
                              .depth = canvas.depth_target(),
                              .with = objects.with({maps, gbuffer})},
                             objects.by(writer(), often(stored)));
            });
            gbuffer.written();

            // 5. Emission, to which light is added. Two surfaces at one depth must not add their emission twice.
            const bool emits =
                objects.write_emission(frame, canvas, cull.is("geometry") ? emission_culled : objects.emission());

            // 6. Lighting of every pixel: ambient light and lights without a volume, or the lights of the pixel's tile.
            const std::vector<With> with{lights, shadow, gbuffer, maps.surface, maps.lamps};
            deferred.update(frame, scene, view, gbuffer, lights);
            const ImageView hdr = canvas.color_overwritten();
            std::vector<Resource> reads{canvas.depth(frame)};
            if (emits) reads.emplace_back(hdr);
            frame.compute(gbuffer.method.is("tiled") ? "tiles" : "full_screen",
                          {.reads = reads, .writes = {hdr}, .with = with}, [&](Compute& pass) {
                              deferred.light_pixels(pass, hdr, scene.ambient(), scene.file.background, ggx, emits);
                          });

            // 7. Light volumes: each other light, added where its volume covers a surface.
            if (deferred.has_volumes())
                frame.raster("volumes",
                             {.color = {canvas.color_target()}, .depth = canvas.depth_read_only(), .with = with},
                             [&](Raster& pass) { deferred.light_volumes(pass, ggx); });

            // 8. Surfaces that the G-buffer cannot hold; or a view of one of its channels.
            if (gbuffer.show.is("picture")) {
                objects.draw_lit(frame, view, canvas, "unstored", often(objects.batches_by_stored(false)));
                if (scene.transparent().size() > 0) lights.record(frame, scene, view, canvas.depth(frame));
            } else {
                deferred.show(frame, canvas, gbuffer);
            }
        }

        // 9. Transparent surfaces, back to front; sRGB encoding.
        draw_transparent(frame, view, canvas, world.drawings());
        if (above_m > 0.0f) show_from_above(frame);
        encode_srgb(frame);
    }
    // [/frame]

    const SurfacePipelines& writer() const {
        return cull.is("fixed")      ? objects.written()
               : cull.is("geometry") ? write_culled
               : cull.is("none")     ? write_all
                                     : write_left_out;
    }

    // Batches in the knob's order, repeated `overdraw` times.
    std::vector<Batch> often(const std::vector<Batch>& given) const {
        const std::vector<Batch> batches = ordered(given);
        std::vector<Batch> drawn;
        for (int i = 0; i < overdraw; ++i) drawn.insert(drawn.end(), batches.begin(), batches.end());
        return drawn;
    }

    // Split into items unless the order is the file's; culling keeps its own lists.
    std::vector<Batch> ordered(const std::vector<Batch>& batches) const {
        if (order.is("file") || culling.culls()) return batches;
        std::vector<std::pair<float, uint32_t>> keys;
        for (const Batch& batch : batches)
            for (uint32_t i = batch.first; i < batch.first + batch.count; ++i) {
                const float away_m = glm::distance(scene.items[i].bounds.center(), camera.position);
                keys.emplace_back(order.is("random")          ? scattered_number(1, i, 0)
                                  : order.is("front_to_back") ? away_m
                                                              : -away_m,
                                  i);
            }
        std::sort(keys.begin(), keys.end());
        std::vector<Batch> drawn;
        for (const auto& [key, i] : keys) drawn.emplace_back(scene, i, 1u);
        return drawn;
    }

    // Objects drawn by the picture, from behind and above its camera.
    void show_from_above(Frame& frame) {
        const glm::vec3 ahead = camera.target - camera.position;
        const glm::vec3 along = glm::normalize(glm::vec3(ahead.x, 0.0f, ahead.z) + glm::vec3(0.0f, 0.0f, 1e-6f));
        Camera above = camera;
        above.position += above_m.value * glm::vec3(-0.5f * along.x, 1.0f, -0.5f * along.z);
        above.target = camera.position + 0.7f * above_m.value * along;
        above.near_m = std::max(camera.near_m, 0.02f * above_m.value);
        View view = view_of(above, frame);
        view.id = derived_.of(view.id);
        Canvas canvas(frame.hdr, frame.depth, glm::vec4(scene.file.background, 0.0f));
        objects.draw_kept(frame, view, canvas);
    }

    // Study values: number of objects drawn; or G-buffer size, and mean error of normals and positions.
    void measure(Gpu& gpu, glm::uvec2 size, nlohmann::json& error) override {
        if (world.town.objects > 0) {
            for (int again = 0; again < 2; ++again) render_linear(*this, gpu, size);  // the first has no previous frame
            error["drawn"] = culling.culls() ? culling.drawn() : scene.opaque().size();
            error["host_ms"] = culling.host_ms();
            return;
        }
        gbuffer.show.set("loss");
        const glm::vec2 lost = mean_loss(render_linear(*this, gpu, size));
        error["bytes_per_pixel"] = gbuffer.bytes_per_pixel();
        error["normal_deg"] = lost.x;
        error["position_mm"] = lost.y;
    }

  private:
    DerivedViews derived_;
};

CHAPTER(Deferred)
