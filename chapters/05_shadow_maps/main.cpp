// Chapter 05: shadows from maps of depth, as each light sees the scene.
#include <fmt/core.h>

#include <nlohmann/json.hpp>

#include "01_obj/model_chapter.h"
#include "04_surface_maps/maps.h"
#include "05_shadow_maps/rays.h"
#include "05_shadow_maps/shadow.h"
#include "05_shadow_maps/sphere_shadow.h"
#include "05_shadow_maps/wrong_shares.h"
#include "common/window/run.h"

using namespace lightwalk;

struct ShadowMaps : ModelChapter {
    Maps maps{*this, "maps"};
    Lights lights{*this, "lights"};
    Shadow shadow{*this, "shadow"};
    Rays rays{*this, "rays"};
    SphereShadow sphere_shadow{*this, "sphere_shadow"};
    Choice visibility{*this, "visibility", {"maps", "rays"}, "maps", "rays: the truth, from all of each lamp"};
    Knob<float> lamp{*this, "lamp", 1.0f, {0.0f, 100.0f}, "by what the sizes of all lamps are multiplied"};
    Choice show{*this,
                "show",
                {"picture", "visibility", "wrong", "map", "texels"},
                "picture",
                "wrong: acne red, peter-panning blue, leaks yellow, edges violet; map: which one; texels: their size"};

    // [pipelines]
    static Pipeline shading(const char* vertex, const char* fragment) {
        return graphics({.vertex = vertex, .fragment = fragment});
    }
    Pipeline surface = shading("04_surface_maps/surface.vert", "05_shadow_maps/surface.frag");
    Pipeline displaced = shading("04_surface_maps/displaced.vert", "05_shadow_maps/surface.frag");
    Pipeline shown = shading("04_surface_maps/surface.vert", "05_shadow_maps/shown.frag");
    Pipeline displaced_shown = shading("04_surface_maps/displaced.vert", "05_shadow_maps/shown.frag");
    Pipeline ringed = graphics(
        {.vertex = "04_surface_maps/surface.vert", .fragment = "05_shadow_maps/ringed.frag", .blend = Blend::alpha});
    Pipeline depth = shading("04_surface_maps/surface.vert", "04_surface_maps/depth.frag");
    Pipeline displaced_depth = shading("04_surface_maps/displaced.vert", "04_surface_maps/depth.frag");
    Pipeline caster = graphics({.vertex = "04_surface_maps/surface.vert",
                                .fragment = "04_surface_maps/depth.frag",
                                .cull = VK_CULL_MODE_NONE,
                                .depth_clamp = true});
    // [/pipelines]
    bool has_rays = false;  ///< of this scene

    ShadowMaps() {
        shadow.method.alone = true;                   // --method is about shadows here
        lights.method.change_default("every_light");  // these scenes have few
    }
    std::string default_scene() const override { return "scenes/colonnade.json"; }
    std::string load_key() const override { return maps.load_key(); }
    bool animated() const override { return maps.animated() || scene.moves(); }
    void prepare(Gpu& gpu) override {
        maps.prepare(gpu, scene);
        shadow.forget();
        has_rays = false;
    }

    // The share of pixels with each kind of wrong shadow, from a picture a quarter as wide: many rays for every pixel.
    void measure(Gpu& gpu, glm::uvec2 size, nlohmann::json& error) override {
        show.set("wrong");
        Frame own(gpu);
        render(*this, own, {glm::max(size / 4u, 1u), 0.0f, 0, {}});
        wrong_shares(gpu, own.hdr, error);
    }

    std::vector<Light> lamps() const {
        std::vector<Light> all = scene.file.lights;
        for (Light& light : all) light.size_m *= lamp, light.size_rad = std::min(light.size_rad * lamp, 1.5f);
        return all;
    }

    // What the shading pass is given: rays only where they are asked.
    std::vector<With> given(Frame& frame, bool plain) {
        std::vector<With> with{maps, lights, shadow};
        if (!plain) {
            if (!std::exchange(has_rays, true)) rays.prepare(frame.gpu, scene, maps.cutoff);
            rays.record(frame, scene);
            with.push_back(rays);
        }
        if (sphere_shadow) with.push_back(sphere_shadow);
        return with;
    }

    // [frame]
    void frame(Frame& frame) override {
        set_view(frame);
        const bool by_rays = visibility.is("rays") || show.is("wrong"), plain = show.is("picture") && !by_rays;

        // 1. The lights of chapter 03, into tiles or clusters where those are its method.
        lights.update(frame, scene, lamps());
        if (lights.needs_depth())
            frame.raster("depth", {.depth = frame.depth, .with = {maps}},
                         [&](Raster& pass) { maps.draw(pass, scene, depth, displaced_depth); });
        lights.record(frame, scene, camera);

        // 2. Depth from those that cast shadows. What textures cut holes into is drawn with its maps.
        const auto has_holes = [&](const DrawItem& item) { return maps.has_holes(item); };
        shadow.record(frame, scene, lights, camera,
                      {.with = {maps}, .draw = [&](Raster& pass, const DrawList& casters) {
                           pass.use(shadow.solid).draw(casters.where(std::not_fn(has_holes)));
                           maps.draw(pass, scene, casters.where(has_holes), caster, caster);
                       }});

        // 3. Every surface; each light as far as it is visible. A planet and its ring need no map.
        sphere_shadow.update(scene);
        const Pipeline& loaded = sphere_shadow ? ringed : plain ? surface : shown;
        frame.raster("shade",
                     {.color = {clear(frame.hdr, glm::vec4(scene.file.background, 0.0f))},
                      .depth = frame.depth,
                      .with = given(frame, plain)},
                     [&](Raster& pass) { maps.draw(pass, scene, loaded, plain ? displaced : displaced_shown); });

        // 4. Linear light to the codes a screen expects.
        encode_srgb(frame);
    }
    // [/frame]

    std::string why_not_finite() const override { return visibility.is("rays") ? rays.why_not_finite() : ""; }

    std::vector<std::string> status() const override {
        return {fmt::format("{} shadow maps, {} drawn", shadow.views, shadow.drawn_views)};
    }
};

CHAPTER(ShadowMaps)
