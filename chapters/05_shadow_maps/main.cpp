// Chapter 05: shadow maps, depth as seen from each light.
#include <array>
#include <cstring>
#include <glm/gtc/packing.hpp>
#include <nlohmann/json.hpp>

#include "01_obj/model_chapter.h"
#include "05_shadow_maps/lit_stage.h"
#include "05_shadow_maps/shadow_error.h"
#include "common/window/run.h"

using namespace lightwalk;

namespace {

// Adds the percentages of surface pixels with acne, peter_panning, leak and edge (shadow_error.h). Alpha of `picture` (RGBA16F):
// 1 and the kind of error, or 0 for the background.
void wrong_shares(Gpu& gpu, const Image& picture, nlohmann::json& error) {
    const std::vector<std::byte> texels = gpu.read_back(picture);
    std::array<size_t, 6> count{};
    for (size_t i = 6; i < texels.size(); i += 8) {
        uint16_t alpha = 0;
        std::memcpy(&alpha, texels.data() + i, 2);
        ++count.at(static_cast<size_t>(glm::unpackHalf1x16(alpha)));
    }
    const double surface = std::max(1.0, static_cast<double>(texels.size() / 8 - count[0]));
    const auto add = [&](const char* name, uint32_t kind) {
        error[name] = 100.0 * static_cast<double>(count.at(1 + kind)) / surface;
    };
    add("acne", SHADOW_ACNE);
    add("peter_panning", SHADOW_PETER_PANNING);
    add("leak", SHADOW_LEAK);
    add("edge", SHADOW_EDGE);
}

}  // namespace

struct ShadowMaps : ModelChapter {
    LitStage world{*this};

    ShadowMaps() {
        world.objects.shadow.method.preferred = true;  // --method is about shadows here
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
