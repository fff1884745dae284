// Chapter 07: mipmaps, the smaller levels of textures, built on the GPU in several ways and compared.
#include <nlohmann/json.hpp>

#include "01_obj/model_chapter.h"
#include "04_surface_maps/surface_scene.h"
#include "07_mipmaps/flicker.h"
#include "07_mipmaps/level_view.h"
#include "07_mipmaps/mip_bench.h"
#include "common/app/target.h"
#include "common/window/run.h"

using namespace lightwalk;

struct Mipmaps : ModelChapter {
    MipChain mips{*this, "mips"};
    LevelView viewer{*this, "viewer"};
    SurfaceScene objects{*this, "objects"};  // chapter 04's surfaces, with levels made here
    Choice show{
        *this,
        "show",
        {"scene", "split", "level"},
        "scene",
        "Picture shown: the scene, the scene with its left half drawn without levels, or one level of a texture"};
    Knob<float> walk_m_s{*this, "walk_m_s", 0.0f, {-10.0f, 10.0f}, "Walking speed of the camera", "m/s"};
    Knob<bool> remake{*this, "remake", true,
                      "Rebuild all levels in every frame; off: keep the levels of the first frame"};

    Pipeline halves = compute({.shader = "07_mipmaps/halves.comp"});
    Target left{*this, {.name = "without levels"}};
    LevelledMaps textures{*this, "textures"};
    Flicker flicker{*this, "flicker"};

    Mipmaps() {
        mips.method.preferred = true;  // --method is about levels here
        objects.maps.makes_levels = false;
        objects.maps.method.change_default("normal");
        commands = {{"mip-bench", "FILE",
                     "measures every method from 64x64 to 8192x8192 texels and writes the result as a study",
                     [](const std::string& file, const Options& o, auto&) { return run_mip_bench(file, o); }}};
    }
    std::string default_scene() const override { return "scenes/tiled_hall.json"; }
    bool animated() const override { return walk_m_s != 0 || ModelChapter::animated(); }
    std::vector<std::string> status() const override {
        return show.is("level") ? std::vector{viewer.text()} : std::vector<std::string>{};
    }

    void measure(Gpu& gpu, glm::uvec2 size, nlohmann::json& error) override {
        error["flicker"] = flicker.measure(*this, gpu, size, {mips.method, walk_m_s, remake});
    }

    // Chapter 04's surfaces, with levels or with the first ones alone.
    void draw_objects(Frame& frame, const View& view, const Image& into, bool levels) {
        textures.use(scene, levels);
        objects.shading.reads = textures.reads();
        Canvas canvas(into, frame.depth, glm::vec4(scene.file.background, 1.0f));
        draw(frame, view, canvas, {objects});
    }

    // The left half again, without levels.
    void split(Frame& frame, const View& view) {
        draw_objects(frame, view, left, false);
        frame.compute("halves", {.reads = {left, frame.hdr}, .writes = {frame.hdr}}, [&](Compute& pass) {
            pass.use(halves).set("left", left).set("result", frame.hdr).dispatch_threads(frame.size);
        });
    }

    // [frame]
    void frame(Frame& frame) override {
        const View view = set_view(frame, camera.walked(walk_m_s * frame.time_s));

        // 1. The levels of every texture.
        if (remake || !textures.recorded()) textures.record(frame, mips, objects.maps.cutoff);

        // 2. The scene with these levels, or one level by itself.
        if (show.is("level") && !textures.entries().empty())
            viewer.record(frame, textures, mips);
        else
            draw_objects(frame, view, frame.hdr, !mips.method.is("none"));
        if (show.is("split")) split(frame, view);

        // 3. Linear light, encoded as sRGB.
        encode_srgb(frame);
    }
    // [/frame]
};

CHAPTER(Mipmaps)
