// Chapter 16: volumes: a nebula in a sphere of glass, a head that was scanned.
#include "01_obj/model_chapter.h"
#include "08_bloom/bloom.h"
#include "09_post_effects/post.h"
#include "16_volume/volume_world.h"
#include "common/window/run.h"

using namespace lightwalk;

struct VolumeChapter : ModelChapter {
    VolumeWorld world{*this};
    Bloom bloom{*this, "bloom"};
    Post post{*this, "post"};

    VolumeChapter() {
        set_look(world, *this);
        world.volume.method.preferred = true;  // --method is about the march here
    }
    std::string default_scene() const override { return "scenes/light_in_rings.json"; }

    // [frame]
    void frame(Frame& frame) override {
        const View view = set_view(frame, world);

        // 1. Solid objects, blurred by the lens, then the volume before and between them (volume_world.h).
        Canvas canvas(frame.hdr, frame.depth, world.background());
        world.draw_light(frame, view, canvas);

        // 2. Glare of bright areas, tones of a film and its grain.
        bloom.record(frame, frame.hdr);
        post.record(frame, frame.hdr);

        // 3. sRGB encoding.
        encode_srgb(frame);
    }
    // [/frame]
};

CHAPTER(VolumeChapter)
