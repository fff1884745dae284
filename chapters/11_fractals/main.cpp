// Chapter 11: fractals: a Julia set in four dimensions, and a landscape of noise.
#include <nlohmann/json.hpp>

#include "01_obj/model_chapter.h"
#include "11_fractals/depth_error.h"
#include "common/window/run.h"

using namespace lightwalk;

struct Fractals : ModelChapter {
    EnvironmentLight environment{*this, "environment"};
    Julia julia{*this, "julia"};
    DepthError depth_error;

    Fractals() { julia.method.alone = true; }
    std::string default_scene() const override { return "scenes/julia_sunset.json"; }
    bool animated() const override { return julia.animated(); }

    // For the study: where rays end, against double precision.
    void measure(Gpu& gpu, glm::uvec2 size, nlohmann::json& error) override {
        samples.value = 1;
        Frame own(gpu);
        render(*this, own, {.size = size});
        depth_error.measure(gpu, julia, camera, 0.0, error);
    }

    // [frame]
    void frame(Frame& frame) override {
        set_view(frame);
        environment.record(frame, scene);
        julia.record(frame, scene, camera, environment);
        encode_srgb(frame);
    }
    // [/frame]
};

CHAPTER(Fractals)
