// Chapter 12: skin, subsurface scattering by blurs of light in texture space and its approximations.
#include <nlohmann/json.hpp>

#include "01_obj/model_chapter.h"
#include "12_skin/head.h"
#include "common/app/show_image.h"
#include "common/window/run.h"

using namespace lightwalk;

struct SkinChapter : ModelChapter {
    Portrait world{*this};
    Head& head = world.head;
    Choice show{
        *this,
        "show",
        {"picture", "irradiance", "level", "diffused", "stretch", "occlusion", "thickness", "specular", "seams"},
        "picture",
        "Image shown: the picture; the maps of irradiance, one Gaussian, their sum, stretch, ambient occlusion or "
        "thickness; the specular reflection alone; or the borders of the charts"};
    Knob<int> level{*this, "level", 0, {0, 5}, "Gaussian to show (show level): 0 is the narrowest"};

    SkinChapter() {
        head.skin.method.preferred = true;  // --method is about skin here
    }
    std::string default_scene() const override { return "scenes/portrait.json"; }

    // For the study: how wide the widest Gaussian is on the screen, in pixels.
    void measure(Gpu&, glm::uvec2 size, nlohmann::json& error) override {
        error["widest_px"] =
            Skin::widest_px(world.dolly * glm::length(camera.position - camera.target), camera, size.y);
    }

    // [frame]
    void frame(Frame& frame) override {
        const View view = set_view(frame, world);

        // 1. The light on the map of the skin, its blur, and the head in its environment (head.cpp).
        head.shown = show.is("specular")    ? Skin::Shown::specular
                     : show.is("thickness") ? Skin::Shown::thickness
                     : show.is("seams")     ? Skin::Shown::seams
                                            : Skin::Shown::all;
        Canvas canvas(frame.hdr, frame.depth, world.background());
        world.draw_light(frame, view, canvas);

        // 2. One of the skin's maps instead of the picture, if the knob says so.
        const glm::vec3 gain = show.is("stretch") ? glm::vec3(0.2f, 0.2f, 0.0f) : glm::vec3(1.0f);
        if (const Image* map = head.skin.map(show.text(), size_t(level)))
            show_image(frame, *map, {.gain = gain, .aspect = 4.0f / 3});

        // 3. Linear light, encoded as sRGB.
        encode_srgb(frame);
    }
    // [/frame]
};

CHAPTER(SkinChapter)
