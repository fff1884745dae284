// Chapter 15: terrain, water and transparent surfaces under a sky.
#include <nlohmann/json.hpp>

#include "09_post_effects/finished_chapter.h"
#include "15_terrain_water/ground.h"
#include "15_terrain_water/land.h"
#include "15_terrain_water/shore.h"

using namespace lightwalk;

struct TerrainWater : FinishedChapter<Shore> {
    TerrainWater() {
        world.land.method.preferred = true;  // --method is about the ground here
    }
    std::string default_scene() const override { return "scenes/valley.json"; }

    // The camera of a window stays at a person's height above the ground.
    std::optional<float> lowest_eye_m(const glm::vec3& position) override {
        if (!gpu_ || !world.ground.exists()) return {};
        if (!heights_made_.is_current(world.ground.epoch(), scene.epoch)) heights_ = read_heights(*gpu_, world.ground);
        const auto ground_m = heights_.height_at({position.x, position.z});
        return ground_m ? std::optional(*ground_m + 1.7f) : std::nullopt;
    }

    // For the study: where the ground lies, against rays.
    void measure(Gpu& gpu, glm::uvec2 size, nlohmann::json& error) override {
        if (world.ground.exists()) measure_land(*this, world.land, gpu, size, error);
    }

    void prepare(Gpu& gpu, Scene&) override { gpu_ = &gpu; }

  private:
    Gpu* gpu_ = nullptr;
    GroundHeights heights_;
    Fingerprint heights_made_;
};

CHAPTER(TerrainWater)
