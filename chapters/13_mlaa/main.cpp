// Chapter 13: staircases made smooth, in the finished picture or before it is finished.
#include <fmt/core.h>

#include <nlohmann/json.hpp>

#include "01_obj/model_chapter.h"
#include "05_shadow_maps/shadow.h"
#include "06_deferred/surfaces.h"
#include "13_mlaa/edge_error.h"
#include "13_mlaa/four_samples.h"
#include "13_mlaa/half_plane.h"
#include "13_mlaa/mlaa.h"
#include "13_mlaa/other_pictures.h"
#include "common/window/run.h"

using namespace lightwalk;

struct MlaaChapter : ModelChapter {
    Mlaa antialias{*this, "mlaa"};
    Maps maps{*this, "maps"};
    Lights lights{*this, "lights"};
    Shadow shadow{*this, "shadow"};
    HalfPlane half_plane{*this, "half_plane"};
    Choice world{*this,
                 "world",
                 {"objects", "julia", "terrain", "head", "half_plane"},
                 "objects",
                 "what is drawn: the scene's objects, what chapters 11 and 12 draw, or black and white"};
    Choice clip{*this, "clip", {"before", "after"}, "before", "when what a screen cannot show is cut off: pixels mix"};
    Choice show{*this, "show", {"picture", "edges", "lengths"}, "picture", "or the edges that were found in it"};

    const SurfacePipelines depth{{.fragment = "04_surface_maps/depth.frag"}};
    Pipeline caster = graphics({.vertex = "04_surface_maps/surface.vert",
                                .fragment = "04_surface_maps/depth.frag",
                                .cull = VK_CULL_MODE_NONE,
                                .depth_clamp = true});
    const SurfacePipelines surface{{.fragment = "13_mlaa/surface.frag"}};
    Pipeline look = compute({.shader = "13_mlaa/look.comp"});
    Pipeline cut_off = compute({.shader = "13_mlaa/clip.comp"});
    OtherPictures others{*this};
    FourSamples four_samples{*this};
    EdgeError edge_error;

    MlaaChapter() {
        antialias.method.alone = true;  // --method is about edges here
        maps.method.change_default("normal");
        lights.method.change_default("every_light");
    }
    std::string default_scene() const override { return "scenes/city.json"; }
    std::string load_key() const override { return maps.load_key() + world.text(); }
    bool animated() const override { return maps.animated() || scene.moves() || world.is("terrain"); }
    void prepare(Gpu& gpu) override {
        maps.prepare(gpu, scene);
        shadow.forget();
        if (world.is("head")) others.prepare_head(gpu, scene);
    }

    // For the study: the error of those pixels alone through which an outline runs, and how many were mixed.
    void measure(Gpu& gpu, glm::uvec2 size, nlohmann::json& error) override {
        edge_error.measure(*this, antialias, gpu, size, error);
    }

    // Into a map of shadows: what textures cut holes into is drawn with its maps.
    Shadow::Casters casters() const {
        return {{maps}, [this](Raster& pass, const DrawList& all) {
                    const auto has_holes = [this](const DrawItem& item) { return maps.has_holes(item); };
                    pass.use(shadow.solid).draw(all.where(std::not_fn(has_holes)));
                    maps.draw(pass, scene, all.where(has_holes), caster, caster);
                }};
    }

    // Chapter 04's surfaces under chapter 03's lights with chapter 05's shadows, seen through one sample of each pixel,
    // or four.
    void draw_objects(Frame& frame) {
        const auto draw = [&](const SurfacePipelines& by) {
            return [&](Raster& pass) { maps.draw(pass, scene, by.loaded, by.displaced); };
        };
        if (lights.needs_depth()) frame.raster("depth", {.depth = frame.depth, .with = {maps}}, draw(depth));
        lights.record(frame, scene, camera);
        const glm::vec4 background(scene.file.background, 1.0f);
        RasterTargets targets = antialias.method.is("msaa_4x")
                                    ? four_samples.multisampled(frame, frame.hdr, background)
                                    : RasterTargets{.color = {clear(frame.hdr, background)}, .depth = frame.depth};
        targets.with = {maps, lights, shadow};
        frame.raster("shade", targets, draw(surface));
    }

    void draw_world(Frame& frame) {
        if (world.is("julia")) return others.draw_julia(frame, scene, camera);
        if (world.is("terrain")) return others.draw_terrain(frame, scene, camera);
        if (world.is("half_plane")) return half_plane.draw(frame);
        set_view(frame);
        if (world.is("head")) return others.draw_head(frame, scene, camera, {maps, lights, shadow});
        draw_objects(frame);
    }

    void draw_light(Frame& frame) {
        set_view(frame);
        lights.update(frame, scene, scene.file.lights);
        if (world.is("objects")) shadow.record(frame, scene, lights, camera, casters());
        if (antialias.method.is("supersample_4"))
            four_samples.supersample(frame, [&] { draw_world(frame); });
        else
            draw_world(frame);
        if (clip.is("before") && !world.is("objects"))
            frame.compute("clip", {.reads = {frame.hdr}, .writes = {frame.hdr}},
                          [&](Compute& pass) { pass.use(cut_off).set("hdr", frame.hdr).dispatch_threads(frame.size); });
    }

    // [frame]
    void frame(Frame& frame) override {
        // 1. A picture in linear light, or the mean of four.
        draw_light(frame);

        // 2. Its edges made smooth, where that was not done while it was drawn.
        antialias.record(frame, frame.hdr);

        // 3. What is looked at.
        if (!show.is("picture") && antialias.follows_edges())
            frame.compute("look", {.reads = {antialias.distances(), frame.hdr}, .writes = {frame.hdr}},
                          [&](Compute& pass) {
                              pass.use(look).set("distances", antialias.distances(), nearest_clamp);
                              pass.set("picture", frame.hdr).dispatch_threads(frame.size);
                          });

        // 4. Linear light to the codes a screen expects.
        encode_srgb(frame);
    }
    // [/frame]

    std::vector<std::string> status() const override {
        if (!antialias.count) return {};
        const Mlaa::Counts counts = antialias.counts();
        return {fmt::format("{} pixels beside an edge, {} mixed", counts.listed, counts.changed)};
    }
};

CHAPTER(MlaaChapter)
