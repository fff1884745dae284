// Chapter 19: a film of all chapters, with music, that can be set to any time.
#include <nlohmann/json.hpp>

#include "01_obj/model_chapter.h"
#include "05_shadow_maps/lit_scene.h"
#include "09_post_effects/post.h"
#include "13_mlaa/mlaa.h"
#include "19_ambiance/benchmark.h"
#include "19_ambiance/film_out.h"
#include "19_ambiance/level_file.h"
#include "19_ambiance/path_error.h"
#include "19_ambiance/reel.h"
#include "common/window/run.h"

using namespace lightwalk;

struct Ambiance : ModelChapter {
    Choice method{
        *this,
        "method",
        {"as_set", "linear", "catmull_rom", "centripetal", "arc_length", "exact"},
        "as_set",
        "Path of cameras: as the film says; straight lines; uniform or centripetal Catmull-Rom; that at an even "
        "speed by a table of 64 lengths, or of 1,024 (the reference)"};
    Reel reel{*this, "reel"};
    LitScene objects{*this, "objects"};  // of a scene that is no film
    Mlaa antialias{*this, "mlaa"};
    Post post{*this, "post"};
    FilmOut out{*this, "out"};

    Ambiance() {
        method.alone = true;
        post.tone.change_default("off");  // the scenes have their own
        objects.in_use = [this] { return !reel.is_open(); };
        objects.lights.method.change_default("every_light");
        commands = {{"levels", "FILE", "Write the levels of the music FILE beside it, for films, and exit",
                     [](const std::string& file, const Options&, auto&) { return write_levels(file), 0; }},
                    {"film", "FILE", "Write the film to FILE (.mp4, .mkv, .raw), and exit",
                     [this](const std::string& file, const Options& options, std::unique_ptr<Gpu>& gpu) {
                         return out.write(*this, reel, file, options, gpu);
                     }},
                    {"benchmark", "FILE", "Write what each scene costs as JSON, and exit",
                     [this](const std::string& file, const Options& options, std::unique_ptr<Gpu>& gpu) {
                         return run_benchmark(*this, reel, antialias, file, options, gpu);
                     }}};
    }
    std::string default_scene() const override { return "films/ambiance.film"; }

    Model load_model(const std::filesystem::path& file) override {
        if (!is_film_file(file)) return ModelChapter::load_model(file);
        Model none;  // the reel itself reads the file
        none.materials.emplace_back();
        return none;
    }

    // [ready]
    void make_ready(Gpu& gpu, glm::uvec2 size, float time_s) override {
        std::optional<PathKind> kind;
        if (!method.is("as_set")) kind = {static_cast<Spline>(std::min<size_t>(method.index - 1, 2)), 0};
        if (method.is("arc_length")) kind->pieces = 64;
        if (method.is("exact")) kind->pieces = 1024;
        reel.choose(kind);
        if (plays) reel.load_sound();
        reel.make_ready(gpu, size, static_cast<double>(time_s), out.latest_s(samples), plays);
    }
    // [/ready]

    // [frame]
    void frame(Frame& frame) override {
        const double time_s = static_cast<double>(frame.time_s) + out.later_s(frame.samples.index, frame.samples.count);

        // 1. What is on at this time: one scene, or two; or the one scene that was given.
        if (reel.is_open()) {
            reel.record(frame, time_s);
        } else {
            Canvas canvas(frame.hdr, frame.depth, glm::vec4(scene.file.background, 1.0f));
            draw(frame, set_view(frame), canvas, {objects});
        }

        // 2. Chapter 13's edges, before chapter 09's grain, which has none.
        antialias.record(frame, frame.hdr);
        post.record(frame, frame.hdr);

        // 3. Titles, and the codes that a screen expects.
        reel.record_titles(frame, frame.hdr, time_s);
        encode_srgb(frame);
    }
    // [/frame]

    // For the study: how far the camera is from its reference path, and how evenly it moves.
    void measure(Gpu&, glm::uvec2, nlohmann::json& error) override { measure_paths(reel.film(), error); }
};

CHAPTER(Ambiance)
