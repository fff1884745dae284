// Chapter 15: terrain, water and transparent surfaces under a sky.
#include <nlohmann/json.hpp>

#include "01_obj/model_chapter.h"
#include "08_bloom/bloom.h"
#include "09_post_effects/post.h"
#include "15_terrain_water/land_error.h"
#include "15_terrain_water/shore.h"
#include "common/window/run.h"

using namespace lightwalk;

struct TerrainWater : ModelChapter {
    Shore shore{*this};
    Bloom bloom{*this, "bloom"};
    Post post{*this, "post"};

    TerrainWater() {
        set_look(shore, *this);
        shore.land.method.preferred = true;  // --method is about the ground here
    }
    std::string default_scene() const override { return "scenes/valley.json"; }

    // For the study: where the ground lies, against rays.
    void measure(Gpu& gpu, glm::uvec2 size, nlohmann::json& error) override {
        if (shore.ground.exists()) measure_land(*this, shore.land, gpu, size, error);
    }

    // [frame]
    void frame(Frame& frame) override {
        const View view = set_view(frame, shore);

        // 1. Ground with its buildings and objects, then planet and stars behind, the water, and air and fog in
        //    front; then transparent surfaces (shore.cpp).
        Canvas canvas(frame.hdr, frame.depth, shore.background());
        shore.draw_light(frame, view, canvas);

        // 2. Chapter 08's bloom, chapter 09's tones, and sRGB encoding.
        bloom.record(frame, frame.hdr);
        post.record(frame, frame.hdr);
        encode_srgb(frame);
    }
    // [/frame]
};

CHAPTER(TerrainWater)
