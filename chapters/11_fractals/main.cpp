// Chapter 11: fractals: a Julia set in four dimensions, and a landscape of noise.
#include "01_obj/model_chapter.h"
#include "11_fractals/julia.h"
#include "common/window/run.h"

using namespace lightwalk;

struct Fractals : ModelChapter {
    EnvironmentLight environment{*this, "environment"};
    Julia julia{*this, "julia"};

    std::string default_scene() const override { return "scenes/julia_sunset.json"; }
    bool animated() const override { return julia.animated(); }

    void frame(Frame& frame) override {
        set_view(frame);
        environment.record(frame, scene);
        julia.record(frame, scene, camera, environment);
        encode_srgb(frame);
    }
};

CHAPTER(Fractals)
