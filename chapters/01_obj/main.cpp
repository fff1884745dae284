// Chapter 01: from a text file to a shaded mesh.
#include "01_obj/load_bench.h"
#include "01_obj/model_chapter.h"
#include "common/app/options.h"
#include "common/window/run.h"

using namespace lightwalk;

struct Obj : ModelChapter {
    // The exercises complete the textbook loader; the others show faster ways.
    Choice method{*this,
                  "loader",
                  {"textbook", "tinyobjloader", "assimp", "scan", "parallel"},
                  "textbook",
                  "OBJ loader: textbook (built on your exercises), the libraries tinyobjloader and assimp, scan (one "
                  "pass over the bytes), parallel (all cores)"};

    Pipeline clay = graphics({.vertex = "01_obj/mesh.vert", .fragment = "01_obj/clay.frag"});

    Obj() {
        method_knob = "loader";
        subject = std::make_shared<LoaderSubject>(scene.file, method);
        commands = {{"load-bench", "FILE", "time every loader on FILE",
                     [](const std::string& file, const Options&, auto&) { return run_load_bench(file, 5); }},
                    {"dump-mesh", "FILE", "print counts, bounds, materials and a checksum of positions as JSON",
                     [this](const std::string& file, const Options&, auto&) {
                         dump_mesh(file, loader());
                         return 0;
                     }}};
    }
    std::string default_scene() const override { return "scenes/bunny.json"; }
    Loader loader() const override { return loader_from_name(method.text()); }
    std::string load_key() const override { return method.text(); }

    // [frame]
    void frame(Frame& frame) override {
        set_view(frame);

        // 1. The mesh, into the HDR target. Nearer surfaces have greater depth.
        frame.raster("clay",
                     {.color = {clear(frame.hdr, glm::vec4(scene.file.background, 1.0f))}, .depth = frame.depth},
                     [&](Raster& pass) { pass.use(clay).draw(scene); });

        // 2. Linear light, encoded as sRGB.
        encode_srgb(frame);
    }
    // [/frame]
};

CHAPTER(Obj)
