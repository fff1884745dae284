// Chapter 12: skin, subsurface scattering by blurs of light in texture space and its approximations.
#include <fmt/core.h>

#include <nlohmann/json.hpp>

#include "01_obj/model_chapter.h"
#include "12_skin/head.h"
#include "common/window/run.h"

using namespace lightwalk;

struct SkinChapter : ModelChapter {
    LitScene objects{*this, "objects"};  // its lights and maps; the head is what is drawn
    EnvironmentLight environment{*this, "environment"};
    Head head{*this, "head", objects, environment};
    Choice show{
        *this,
        "show",
        {"picture", "irradiance", "level", "diffused", "stretch", "occlusion", "thickness", "specular", "seams"},
        "picture",
        "Image shown: the picture; the maps of irradiance, one Gaussian, their sum, stretch, ambient occlusion or "
        "thickness; the specular reflection alone; or the borders of the charts"};
    Knob<int> level{*this, "level", 0, {0, 5}, "Gaussian to show (show level): 0 is the narrowest"};
    Knob<float> dolly{*this, "dolly", 1.0f, {0.2f, 64.0f}, "Scale factor for the distance of the camera"};
    Pipeline look = compute({.shader = "12_skin/look.comp"});

    SkinChapter() {
        head.skin.method.alone = true;  // --method is about skin here
        objects.maps.method.change_default("normal");
        objects.lights.method.change_default("every_light");
    }
    std::string default_scene() const override { return "scenes/portrait.json"; }

    // For the study: how wide the widest Gaussian is on the screen, in pixels.
    void measure(Gpu&, glm::uvec2 size, nlohmann::json& error) override {
        error["widest_px"] = Skin::widest_px(dolly * glm::length(camera.position - camera.target), camera, size.y);
    }

    // One of the skin's maps in place of the picture.
    void look_at(Frame& frame, const Image& image, glm::vec3 gain) {
        frame.compute("look", {.reads = {image}, .writes = {frame.hdr}}, [&](Compute& pass) {
            pass.use(look).set("image", image, nearest_clamp).set("gain", gain).set("result", frame.hdr);
            pass.dispatch_threads(frame.size);
        });
    }

    void look_at_maps(Frame& frame) {
        const Skin& skin = head.skin;
        if (show.is("stretch")) look_at(frame, skin.layout().stretch, {0.2f, 0.2f, 0.0f});
        if (show.is("occlusion")) look_at(frame, skin.occlusion(), glm::vec3(1));
        if (skin.on_map() && show.is("irradiance")) look_at(frame, skin.irradiance(), glm::vec3(1));
        if (skin.on_map() && show.is("diffused")) look_at(frame, skin.diffused(), glm::vec3(1));
        if (skin.sum_count() && show.is("level")) look_at(frame, skin.level(size_t(level)), glm::vec3(1));
    }

    // [frame]
    void frame(Frame& frame) override {
        Camera there = camera;
        there.position = glm::mix(camera.target, camera.position, dolly.value);
        const View view = set_view(frame, there);

        // 1. The light on the map of the skin, its blur, and the head in its environment (head.cpp).
        head.shown = show.is("specular")    ? Skin::Shown::specular
                     : show.is("thickness") ? Skin::Shown::thickness
                     : show.is("seams")     ? Skin::Shown::seams
                                            : Skin::Shown::all;
        Canvas canvas(frame.hdr, frame.depth);
        draw(frame, view, canvas, {head});
        if (!head.skin.empty()) look_at_maps(frame);

        // 2. Linear light to the codes that a screen expects.
        encode_srgb(frame);
    }
    // [/frame]

    std::vector<std::string> status() const override {
        if (!head.skin.on_map() || head.skin.empty()) return {};
        return {fmt::format("the map of light is {} texels wide", head.skin.irradiance().desc.size.x)};
    }
};

CHAPTER(SkinChapter)
