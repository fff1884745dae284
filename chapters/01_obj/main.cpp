// Chapter 01: from a text file to a shaded mesh.
#include "01_obj/load_bench.h"
#include "01_obj/load_study.h"
#include "01_obj/model_chapter.h"

using namespace lightwalk;

struct Obj : ModelChapter {
    // The textbook loader is the one the exercises complete; the others show what more can be had.
    Choice method{
        "loader", {"textbook", "tinyobjloader", "assimp", "scan", "parallel"}, "textbook", "how an OBJ file is read"};

    Knob<int> loads{"loads", 1, {1, 1000000}, "how often a session reads its files; for --loader auto"};

    Pipeline clay = graphics({.vertex = "01_obj/mesh.vert", .fragment = "01_obj/clay.frag"});

    Obj() { method_knob = "loader"; }
    std::string default_scene() const override { return "scenes/bunny.json"; }
    Loader loader() const override { return loader_from_name(method.text()); }
    bool reload_on_toggle() const override { return true; }
    std::string load_key() const override { return method.text(); }

    bool cpu_study(const nlohmann::json& study, nlohmann::json& result) override {
        study_loaders(study, result);
        return true;
    }

    std::vector<std::string> choose_before_loading(double budget) override {
        std::vector<std::string> lines;
        const LoaderCost cost = choose_loader(megabytes(scene.file), loads, budget, lines);
        method.set(std::string(loader_name(cost.loader)));
        return lines;
    }

    // [frame]
    void frame(Frame& frame) override {
        set_view(frame);

        // 1. The mesh into the HDR target; what is nearer has the greater depth.
        frame.raster("clay",
                     {.color = {clear(frame.hdr, glm::vec4(scene.file.background, 1.0f))}, .depth = frame.depth},
                     [&](Raster& pass) { pass.use(clay).draw(scene); });

        // 2. Linear light to the codes a screen expects.
        encode_srgb(frame);
    }
    // [/frame]

    std::vector<Command> commands() override {
        return {{"load-bench", "FILE", "time every loader on FILE; --json for JSON",
                 [](const std::string& file, bool json) { return run_load_bench(file, 5, json); }},
                {"dump-mesh", "FILE", "print counts, bounds, materials and a checksum of positions as JSON",
                 [this](const std::string& file, bool) {
                     dump_mesh(file, loader());
                     return 0;
                 }}};
    }
};

CHAPTER(Obj)
