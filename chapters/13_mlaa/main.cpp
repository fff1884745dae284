// Chapter 13: morphological anti-aliasing, and four other methods to compare it with.
#include <nlohmann/json.hpp>

#include "01_obj/model_chapter.h"
#include "11_fractals/julia.h"
#include "11_fractals/terrain.h"
#include "12_skin/head.h"
#include "13_mlaa/edge_error.h"
#include "13_mlaa/four_samples.h"
#include "13_mlaa/half_plane.h"
#include "13_mlaa/mlaa.h"
#include "common/window/run.h"

using namespace lightwalk;

struct MlaaChapter : ModelChapter {
    Mlaa antialias{*this, "mlaa"};
    LitScene objects{*this, "objects"};
    HalfPlane half_plane{*this, "half_plane"};
    Choice world{*this,
                 "world",
                 {"objects", "julia", "terrain", "head", "half_plane"},
                 "objects",
                 "Picture to filter: the objects of the scene; a Julia set or landscape of chapter 11; the head of "
                 "chapter 12; or a half-plane of black and white"};
    Choice clip{*this,
                "clip",
                {"before", "after"},
                "before",
                "Clipping of light brighter than white: before or after pixels are mixed"};
    Choice show{*this,
                "show",
                {"picture", "edges", "lengths"},
                "picture",
                "Image shown: the picture, the edges found in it, or the lengths of their lines"};

    EnvironmentLight environment{*this, "environment"};
    Julia julia{*this, "julia", environment};
    Terrain terrain{*this, "terrain"};
    Head head{*this, "head", objects, environment};
    const Drawings worlds{objects, julia, terrain, head, half_plane};
    const SurfacePipelines surface{{.fragment = "13_mlaa/surface.frag"}};
    const SurfacePipelines glass =
        LitScene::see_through("13_mlaa/surface.frag", {{"LIGHTS_METHOD", "LIGHTS_METHOD_EVERY_LIGHT"}});
    Pipeline cut_off = compute({.shader = "13_mlaa/clip.comp"});
    FourSamples four_samples{*this};
    EdgeError edge_error;

    MlaaChapter() {
        antialias.method.alone = true;  // --method is about edges here
        objects.maps.method.change_default("normal");
        objects.shading = &surface;
        objects.shaded.reset();
        objects.transparent_shading = &glass;
        julia.in_use = [this] { return world.is("julia"); };
        terrain.in_use = [this] { return world.is("terrain"); };
        head.skin.in_use = [this] { return world.is("head"); };
    }
    std::string default_scene() const override { return "scenes/city.json"; }

    // For the study: the error of those pixels alone through which an outline runs, and how many were mixed.
    void measure(Gpu& gpu, glm::uvec2 size, nlohmann::json& error) override {
        edge_error.measure(*this, antialias, gpu, size, error);
    }

    // The world, seen through one sample of each pixel, or four.
    void draw_light(Frame& frame) {
        const View view = set_view(frame);
        const auto draw_from = [&](const View& from) {
            Canvas canvas(frame.hdr, frame.depth, glm::vec4(scene.file.background, 1.0f));
            if (antialias.method.is("msaa_4x") && world.is("objects")) four_samples.multisample(frame, canvas);
            draw(frame, from, canvas, {worlds[world.index]});
        };
        if (antialias.method.is("supersample_4"))
            four_samples.supersample(frame, view, draw_from);
        else
            draw_from(view);
        if (clip.is("before") && !world.is("objects"))
            frame.compute("clip", {.reads = {frame.hdr}, .writes = {frame.hdr}},
                          [&](Compute& pass) { pass.use(cut_off).set("hdr", frame.hdr).dispatch_threads(frame.size); });
    }

    // [frame]
    void frame(Frame& frame) override {
        // 1. A picture in linear light, or the mean of four.
        draw_light(frame);

        // 2. Anti-aliasing by a filter, unless the picture was drawn with several samples.
        antialias.record(frame, frame.hdr);

        // 3. The edges or the lengths in place of the picture, if the knob says so.
        if (!show.is("picture")) antialias.show_edges(frame, frame.hdr, show.is("lengths"));

        // 4. Linear light to the codes that a screen expects.
        encode_srgb(frame);
    }
    // [/frame]
};

CHAPTER(MlaaChapter)
