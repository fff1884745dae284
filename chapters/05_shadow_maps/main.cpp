// Chapter 05: shadow maps, depth as seen from each light.
#include <nlohmann/json.hpp>

#include "01_obj/model_chapter.h"
#include "05_shadow_maps/lit_stage.h"
#include "05_shadow_maps/wrong_shares.h"
#include "common/window/run.h"

using namespace lightwalk;

struct ShadowMaps : ModelChapter {
    LitStage world{*this};

    ShadowMaps() {
        world.objects.shadow.method.alone = true;  // --method is about shadows here
    }
    std::string default_scene() const override { return "scenes/colonnade_evening.json"; }

    // The share of pixels with each kind of wrong shadow, from a picture a quarter as wide: many rays for every pixel.
    void measure(Gpu& gpu, glm::uvec2 size, nlohmann::json& error) override {
        world.show.set("wrong");
        Frame own(gpu);
        render(*this, own, {glm::max(size / 4u, 1u), 0.0f, 0, {}});
        wrong_shares(gpu, own.hdr, error);
    }

    // [frame]
    void frame(Frame& frame) override {
        const View view = set_view(frame, world);

        // 1. The shadow maps, then every surface, lit by the visible part of each light (lit_stage.cpp, lit_scene.cpp).
        Canvas canvas(frame.hdr, frame.depth, world.background());
        world.draw_light(frame, view, canvas);

        // 2. Linear light, encoded as sRGB.
        encode_srgb(frame);
    }
    // [/frame]

    std::string why_not_finite() const override {
        return world.visibility.is("rays") ? world.rays.why_not_finite() : "";
    }
};

CHAPTER(ShadowMaps)
