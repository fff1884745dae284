// Chapter 08: light that spreads: what is cut out of a picture, how it is blurred, and how it comes back.
#include <nlohmann/json.hpp>

#include "01_obj/model_chapter.h"
#include "04_surface_maps/surface_scene.h"
#include "08_bloom/bloom.h"
#include "08_bloom/point_spread.h"
#include "common/window/run.h"

using namespace lightwalk;

struct BloomChapter : ModelChapter {
    Bloom bloom{*this, "bloom"};
    SurfaceScene objects{*this, "objects"};
    Choice source{*this, "source", {"scene", "spot"}, "scene", "what is spread: the scene, or one bright pixel"};
    Knob<float> spot_x{*this, "spot_x", 0.0f, {-64.0f, 64.0f}, "how far the bright pixel is moved", "px"};
    Choice show{*this, "show", {"picture", "cut_out", "spread", "level"}, "picture", "or one of the bloom's images"};
    Knob<int> level{*this, "level", 2, {0, 24}, "which image between, by the order in which they are made"};
    Knob<float> gain{*this, "gain", 1.0f, {0.0f, 1e6f}, "by what an image of the bloom is multiplied to be shown"};

    Pipeline spot = compute({.shader = "08_bloom/spot.comp"});
    Pipeline look = compute({.shader = "08_bloom/look_at_bloom.comp"});
    PointSpread spreads;

    BloomChapter() {
        bloom.method.alone = true;  // --method is about bloom here
        objects.maps.method.change_default("normal");
        objects.lights.method.change_default("every_light");
    }
    std::string default_scene() const override { return "scenes/neon.json"; }

    // For the study: how far the picture of one bright pixel is from what it should be.
    void measure(Gpu& gpu, glm::uvec2 size, nlohmann::json& error) override {
        source.set("spot"), show.set("spread"), gain.set("1"), bloom.cut.set("none");
        error["psf_l2"] = spreads.error(*this, bloom, gpu, size);
    }

    void draw_spot(Frame& frame) {
        frame.compute("spot", {.writes = {frame.hdr}}, [&](Compute& pass) {
            pass.use(spot).set("spot_x", spot_x.value).set("result", frame.hdr).dispatch_threads(frame.size);
        });
    }

    // Chapter 04's surfaces under chapter 03's lights.
    void draw_scene(Frame& frame) {
        const View view = set_view(frame);
        Canvas canvas(frame.hdr, frame.depth, glm::vec4(scene.file.background, 1.0f));
        draw(frame, view, canvas, {objects});
    }

    // One of the bloom's images in place of the picture; black where nothing was cut out.
    void look_at(Frame& frame, const Image& image) {
        frame.compute("look", {.reads = {image, bloom.dispatches()}, .writes = {frame.hdr}}, [&](Compute& pass) {
            pass.use(look).set("image", image, nearest_clamp).set("gain", gain.value).set("result", frame.hdr);
            pass.set("dispatches", bloom.dispatches())
                .set("picture_in", bloom.picture_in(image))
                .dispatch_threads(frame.size);
        });
    }

    // [frame]
    void frame(Frame& frame) override {
        // 1. A picture in linear light, whose bright parts are brighter than a screen can show.
        source.is("spot") ? draw_spot(frame) : draw_scene(frame);

        // 2. Its bloom.
        bloom.record(frame, frame.hdr);

        // 3. What is looked at.
        if (!show.is("picture") && !bloom.method.is("none"))
            look_at(frame, show.is("cut_out")  ? bloom.cut_out()
                           : show.is("spread") ? bloom.spread()
                                               : bloom.level(static_cast<size_t>(level.value)));

        // 4. Linear light to the codes a screen expects.
        encode_srgb(frame);
    }
    // [/frame]
};

CHAPTER(BloomChapter)
