// Chapter 15: terrain, water and transparent surfaces under a sky.
#include <nlohmann/json.hpp>

#include "01_obj/model_chapter.h"
#include "08_bloom/bloom.h"
#include "09_post_effects/post.h"
#include "15_terrain_water/ground.h"
#include "15_terrain_water/land.h"
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

    // The camera of a window stays at a person's height above the ground.
    std::optional<float> lowest_eye_m(const glm::vec3& position) override {
        if (!gpu_ || !shore.ground.exists()) return {};
        if (!heights_made_.is_current(shore.ground.epoch(), scene.epoch)) heights_ = read_heights(*gpu_, shore.ground);
        const auto ground_m = heights_.height_at({position.x, position.z});
        return ground_m ? std::optional(*ground_m + 1.7f) : std::nullopt;
    }

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

    void prepare(Gpu& gpu, Scene&) override { gpu_ = &gpu; }

  private:
    Gpu* gpu_ = nullptr;
    GroundHeights heights_;
    Fingerprint heights_made_;
};

CHAPTER(TerrainWater)
