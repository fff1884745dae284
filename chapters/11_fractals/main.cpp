// Chapter 11: fractals. A quaternion Julia set, and a landscape of noise.
#include <nlohmann/json.hpp>

#include "01_obj/model_chapter.h"
#include "09_post_effects/post.h"
#include "11_fractals/errors.h"
#include "11_fractals/fractal.h"
#include "common/app/knob_scope.h"
#include "common/window/run.h"

using namespace lightwalk;

struct Fractals : ModelChapter {
    Fractal world{*this};
    Julia& julia = world.set.julia;
    Terrain& terrain = world.terrain;
    Choice method{*this,
                  "method",
                  {"as_set", "fixed", "distance", "relaxed", "cone", "central", "analytic", "exact"},
                  "as_set",
                  "Method of the subject: julia.method or terrain.method as set there, or the one named here; exact is "
                  "the reference of both"};
    DepthError depth_error;

    Fractals() { method.preferred = true; }
    std::string default_scene() const override { return "scenes/julia_sunset.json"; }

    // For the study: where rays end, and how normals lie, against double precision.
    void measure(Gpu& gpu, glm::uvec2 size, nlohmann::json& error) override {
        const Chosen chosen(*this);
        samples.value = 1;
        terrain.show.set("normals");
        Frame own(gpu);
        render(*this, own, {.size = size});
        if (world.subject.is("julia"))
            depth_error.measure(gpu, julia, camera, 0.0, error);
        else
            measure_normals(gpu, terrain, own, error);
    }

    // The subject's method is the one that --method or a study names, while this lives.
    struct Chosen {
        explicit Chosen(Fractals& f) {
            const Choice& named = f.method;
            if (named.is("as_set")) return;
            if (f.world.subject.is("julia")) {
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
        const View view = set_view(frame, world);
        // A set's depth would not be read.
        Canvas canvas(frame.hdr, world.subject.is("julia") ? ImageView() : frame.depth, world.background());
        world.draw_light(frame, view, canvas);

        // Linear light, encoded as sRGB; bright light fades to white.
        encode_film(frame);
    }
    // [/frame]
};

CHAPTER(Fractals)
