// Chapter 04: surface maps for slope, depth, material and holes.
#include <nlohmann/json.hpp>

#include "01_obj/model_chapter.h"
#include "03_attenuation/lights.h"
#include "04_surface_maps/maps.h"
#include "common/window/run.h"

using namespace lightwalk;

struct SurfaceMaps : ModelChapter {
    Maps maps{*this, "maps"};
    Lights lights{*this, "lights"};
    Choice show{*this,
                "show",
                {"shaded", "hit_error", "swim", "normal"},
                "shaded",
                "View: shaded picture, error of the hit point (hit_error), its change as the camera moves (swim), both "
                "in texels of the height map with 32 as white, or the normal"};

    Pipeline surface = graphics({.vertex = "04_surface_maps/surface.vert", .fragment = "04_surface_maps/surface.frag"});
    Pipeline displaced =
        graphics({.vertex = "04_surface_maps/displaced.vert", .fragment = "04_surface_maps/surface.frag"});
    // Alpha blending, back to front by object; chapter 15 has better methods.
    SurfacePipelines see_through{{.fragment = "04_surface_maps/surface.frag",
                                  .depth_write = false,
                                  .blend = Blend::filtered,
                                  .macros = {{"TRANSPARENT", "1"}, {"LIGHTS_METHOD", "LIGHTS_METHOD_EVERY_LIGHT"}}}};
    Pipeline depth = graphics({.vertex = "04_surface_maps/surface.vert", .fragment = "04_surface_maps/depth.frag"});
    Pipeline displaced_depth =
        graphics({.vertex = "04_surface_maps/displaced.vert", .fragment = "04_surface_maps/depth.frag"});

    SurfaceMaps() {
        maps.method.preferred = true;                 // --method is about maps here
        lights.method.change_default("every_light");  // these scenes have few
    }
    std::string default_scene() const override { return "scenes/courtyard.json"; }

    void measure(Gpu& gpu, glm::uvec2 size, nlohmann::json& error) override {
        show.set("hit_error");
        error["hit_texels"] = mean_texels(render_linear(*this, gpu, size));
        show.set("swim");
        error["swim_texels"] = mean_texels(render_linear(*this, gpu, size));
    }

    // [frame]
    void frame(Frame& frame) override {
        const View view = set_view(frame);
        const bool measures = show.is("hit_error") || show.is("swim");
        const glm::vec4 behind(measures ? glm::vec3(-1.0f) : scene.file.background, 1.0f);

        // 1. Lights in a buffer; depth and light lists if the method has cells (chapter 03).
        lights.update(frame, scene, scene.file.lights);
        if (lights.needs_depth())
            frame.raster("depth", {.depth = frame.depth, .with = {maps}},
                         [&](Raster& pass) { maps.draw(pass, scene, scene.opaque(), depth, displaced_depth); });
        lights.record(frame, scene, view, frame.depth);

        // 2. Shading, each item by the shader variant with exactly its maps.
        frame.raster("shade", {.color = {clear(frame.hdr, behind)}, .depth = frame.depth, .with = {maps, lights}},
                     [&](Raster& pass) {
                         maps.draw(pass, scene, scene.opaque(), surface, displaced);
                         const DrawList transparent = scene.transparent().sorted_from(view.eye);
                         maps.draw(pass, scene, transparent, see_through.loaded, see_through.displaced);
                     });

        // 3. Linear light, encoded as sRGB.
        encode_srgb(frame);
    }
    // [/frame]
};

CHAPTER(SurfaceMaps)
