// Chapter 17: the Sun, its planets, and one moon, as their photographs show them.
#include "01_obj/model_chapter.h"
#include "08_bloom/bloom.h"
#include "09_post_effects/post.h"
#include "17_planets/solar_system.h"
#include "common/window/run.h"

using namespace lightwalk;

struct PlanetsChapter : ModelChapter {
    SolarSystem world{*this};
    Bloom bloom{*this, "bloom"};
    Post post{*this, "post"};

    PlanetsChapter() {
        set_look(world, *this);
        world.planets.method.preferred = true;  // --method is about the law here
    }
    std::string default_scene() const override { return "scenes/saturn.json"; }

    // [frame]
    void frame(Frame& frame) override {
        // 1. The camera: the scene's, or that of a flight (solar_system.h).
        const View view = set_view(frame, world);

        // 2. Stars, then the bodies over them, the farthest first.
        Canvas canvas(frame.hdr, frame.depth, world.background());
        world.draw_light(frame, view, canvas);

        // 3. Glare, tones, and sRGB encoding.
        bloom.record(frame, frame.hdr);
        post.record(frame, frame.hdr);
        encode_srgb(frame);
    }
    // [/frame]
};

CHAPTER(PlanetsChapter)
