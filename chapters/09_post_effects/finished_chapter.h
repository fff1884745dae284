// Chapter of one world, finished by bloom and post effects.
#pragma once
#include "01_obj/model_chapter.h"
#include "08_bloom/bloom.h"
#include "09_post_effects/post.h"
#include "common/window/run.h"

namespace lightwalk {

/// The world's look gives the defaults of bloom.* and post.*.
template <class Shown>
struct FinishedChapter : ModelChapter {
    Shown world{*this};
    Bloom bloom{*this, "bloom"};
    Post post{*this, "post"};

    FinishedChapter() { set_look(world, *this); }

    // [frame]
    void frame(Frame& frame) override {
        // 1. The camera: the scene's, or one of the world's own, such as a flight's.
        const View view = set_view(frame, world);

        // 2. The world's drawings, by phase, then transparent surfaces.
        Canvas canvas(frame.hdr, frame.depth, world.background());
        world.draw_light(frame, view, canvas);

        // 3. Chapter 08's bloom, chapter 09's tones, and sRGB encoding.
        bloom.record(frame, frame.hdr);
        post.record(frame, frame.hdr);
        encode_srgb(frame);
    }
    // [/frame]
};

}  // namespace lightwalk
