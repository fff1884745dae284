// Chapter 14: light from all around, out of a picture or out of the scene itself.
#include "01_obj/model_chapter.h"
#include "08_bloom/bloom.h"
#include "09_post_effects/post.h"
#include "14_environment/surroundings.h"
#include "common/window/run.h"

using namespace lightwalk;

struct EnvironmentChapter : ModelChapter {
    Surroundings world{*this};
    Bloom bloom{*this, "bloom"};
    Post post{*this, "post"};

    EnvironmentChapter() {
        set_look(world, *this);
        world.light.method.preferred = true;  // --method is about reflections here
    }
    std::string default_scene() const override { return "scenes/lacquered_statue.json"; }

    // [frame]
    void frame(Frame& frame) override {
        const View view = set_view(frame, world);

        // 1. The light of the surroundings, or of a probe; then the surroundings and their objects
        //    (surroundings.cpp).
        Canvas canvas(frame.hdr, frame.depth, world.background());
        world.draw_light(frame, view, canvas);

        // 2. Chapter 08's bloom, chapter 09's tones, and sRGB encoding.
        bloom.record(frame, frame.hdr);
        post.record(frame, frame.hdr);
        encode_srgb(frame);
    }
    // [/frame]
};

CHAPTER(EnvironmentChapter)
