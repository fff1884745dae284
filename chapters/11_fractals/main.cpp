// Chapter 11: fractals. A quaternion Julia set, and a landscape of noise.
#include <nlohmann/json.hpp>

#include "01_obj/model_chapter.h"
#include "09_post_effects/encode_film.h"
#include "11_fractals/depth_error.h"
#include "11_fractals/normal_error.h"
#include "common/app/knob_scope.h"
#include "common/window/run.h"

using namespace lightwalk;

struct Fractals : ModelChapter {
    Choice world{*this, "world", {"julia", "terrain"}, "julia", "Subject of the picture: a Julia set, or a landscape"};
    Choice method{*this,
                  "method",
                  {"as_set", "fixed", "distance", "relaxed", "cone", "central", "analytic", "exact"},
                  "as_set",
                  "Method of the subject: julia.method or terrain.method as set there, or the one named here; exact is "
                  "the reference of both"};
    EnvironmentLight environment{*this, "environment"};
    Julia julia{*this, "julia", environment};
    Terrain terrain{*this, "terrain"};
    const Drawings worlds{julia, terrain};
    DepthError depth_error;

    Fractals() {
        method.alone = true;
        julia.in_use = [this] { return world.is("julia"); };
        terrain.in_use = [this] { return world.is("terrain"); };
    }
    std::string default_scene() const override { return "scenes/julia_sunset.json"; }

    // For the study: where rays end, and how normals lie, against double precision.
    void measure(Gpu& gpu, glm::uvec2 size, nlohmann::json& error) override {
        const Chosen chosen(*this);
        samples.value = 1;
        terrain.show.set("normals");
        Frame own(gpu);
        render(*this, own, {.size = size});
        if (world.is("julia"))
            depth_error.measure(gpu, julia, camera, 0.0, error);
        else
            measure_normals(gpu, terrain, own, error);
    }

    // The subject's method is the one that --method or a study names, while this lives.
    struct Chosen {
        explicit Chosen(Fractals& f) {
            const Choice& named = f.method;
            if (named.is("as_set")) return;
            if (f.world.is("julia")) {
                const bool is_terrains = named.is("central") || named.is("analytic");
                method.emplace(f.julia.method, is_terrains ? "exact" : named.text());
                return;
            }
            method.emplace(f.terrain.method, named.is("central") ? "central" : "analytic");
            if (named.is("exact")) octaves.emplace(f.terrain.octaves, "fixed");
        }
        std::optional<KnobScope> method, octaves;
    };

    // [frame]
    void frame(Frame& frame) override {
        const Chosen chosen(*this);
        const View view = set_view(frame);
        Canvas canvas(frame.hdr, world.is("julia") ? ImageView() : frame.depth);  // a set's depth would not be read
        draw(frame, view, canvas, {worlds[world.index]});

        // Linear light to the codes that a screen expects; bright light fades to white.
        encode_film(frame);
    }
    // [/frame]
};

CHAPTER(Fractals)
