// Chapter 15: terrain, water and transparent surfaces under a sky.
#include "01_obj/model_chapter.h"
#include "08_bloom/bloom.h"
#include "09_post_effects/post.h"
#include "10_atmosphere/height_fog.h"
#include "10_atmosphere/planet.h"
#include "15_terrain_water/land.h"
#include "common/window/run.h"

using namespace lightwalk;

struct TerrainWater : ModelChapter {
    Atmosphere atmosphere{*this, "atmosphere"};
    Planet sky{*this, "sky", atmosphere};
    Land land{*this, "land", atmosphere};
    HeightFog fog{*this, "fog"};
    Bloom bloom{*this, "bloom"};
    Post post{*this, "post"};

    TerrainWater() {
        sky.map.change_default("plain");
        fog.method.change_default("none");
        bloom.method.change_default("none");
    }
    std::string default_scene() const override { return "scenes/valley.json"; }

    // [frame]
    void frame(Frame& frame) override {
        const View view = set_view(frame);
        scene.set_sun(atmosphere.sun());

        // 1. Ground, then the planet and the stars behind it, and the air and the fog before all of it.
        Canvas canvas(frame.hdr, frame.depth);
        draw(frame, view, canvas, {land, sky, atmosphere, fog});

        // 2. Chapter 08's bloom, chapter 09's tones, and the codes a screen expects.
        bloom.record(frame, frame.hdr);
        post.record(frame, frame.hdr);
        encode_srgb(frame);
    }
    // [/frame]
};

CHAPTER(TerrainWater)
