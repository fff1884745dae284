// Chapter 11: fractals: a Julia set in four dimensions, and a landscape of noise.
#include "01_obj/model_chapter.h"
#include "11_fractals/environment.h"
#include "common/window/run.h"

using namespace lightwalk;

struct Fractals : ModelChapter {
    EnvironmentLight environment{*this, "environment"};
    Pipeline surroundings = compute({.shader = "11_fractals/surroundings.comp"});

    std::string default_scene() const override { return "scenes/julia_sunset.json"; }

    void frame(Frame& frame) override {
        set_view(frame);
        environment.record(frame, scene);
        frame.compute("surroundings", {.writes = {frame.hdr}, .with = {environment}}, [&](Compute& pass) {
            pass.use(surroundings).set("result", frame.hdr).dispatch_threads(frame.size);
        });
        encode_srgb(frame);
    }
};

CHAPTER(Fractals)
