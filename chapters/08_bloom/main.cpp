// Chapter 08: bloom. A bright pass, a blur by one of eight methods, and the sum with the picture.
#include <nlohmann/json.hpp>

#include "01_obj/model_chapter.h"
#include "04_surface_maps/surface_scene.h"
#include "05_shadow_maps/visibility_buffer.h"
#include "08_bloom/bloom.h"
#include "08_bloom/point_spread.h"
#include "common/window/run.h"

using namespace lightwalk;

struct SeenWorld : Surfaces {
    using Surfaces::Surfaces;
    VisibleSurfaces seen{*this, "objects", objects};
    Drawings drawings() override { return {seen}; }
};

struct BloomChapter : ModelChapter {
    Bloom bloom{*this, "bloom"};
    SeenWorld world{*this};
    Choice source{
        *this, "source", {"scene", "spot"}, "scene", "Picture that blooms: the scene, or a single bright pixel"};
    Knob<float> spot_x{*this,
                       "spot_x",
                       0.0f,
                       {-64.0f, 64.0f},
                       "Horizontal position of the bright pixel, from the middle of the picture",
                       "px"};
    Choice show{*this,
                "show",
                {"picture", "cut_out", "spread", "level"},
                "picture",
                "Image shown: the final picture, the light that passed the threshold, the blurred light, or an "
                "intermediate image"};
    Knob<int> level{*this, "level", 2, {0, 24}, "Intermediate image to show, in the order of computation"};
    Knob<float> gain{*this, "gain", 1.0f, {0.0f, 1e6f}, "Scale factor for the brightness of a displayed bloom image"};

    PointSpread point;

    BloomChapter() {
        bloom.method.preferred = true;  // --method is about bloom here
    }
    std::string default_scene() const override { return "scenes/neon.json"; }

    // For the study: error of the image of one bright pixel.
    void measure(Gpu& gpu, glm::uvec2 size, nlohmann::json& error) override {
        source.set("spot");
        show.set("spread");
        gain.set("1");
        bloom.cut.set("none");
        error["psf_l2"] = point.error(*this, bloom, gpu, size);
    }

    // [frame]
    void frame(Frame& frame) override {
        // 1. A picture in linear light, with values above the white of a screen.
        const View view = set_view(frame, world);
        Canvas canvas(frame.hdr, frame.depth, world.background());
        source.is("spot") ? point.draw_spot(frame, spot_x) : world.draw_light(frame, view, canvas);

        // 2. Its bloom.
        bloom.record(frame, frame.hdr);

        // 3. An image of the bloom instead of the picture, if the knob says so.
        if (!show.is("picture") && !bloom.method.is("none"))
            bloom.show(frame, show.is("cut_out") ? 0 : show.is("spread") ? 1 : size_t(level), gain);

        // 4. Linear light, encoded as sRGB.
        encode_srgb(frame);
    }
    // [/frame]
};

CHAPTER(BloomChapter)
