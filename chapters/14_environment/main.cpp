// Chapter 14: light from all around, out of a picture or out of the scene itself.
#include <nlohmann/json.hpp>

#include "09_post_effects/finished_chapter.h"
#include "14_environment/paint_error.h"
#include "14_environment/surroundings.h"

using namespace lightwalk;

struct EnvironmentChapter : FinishedChapter<Surroundings> {
    EnvironmentChapter() {
        world.light.method.preferred = true;  // --method is about reflections here
    }
    std::string default_scene() const override { return "scenes/lacquered_statue.json"; }

    // Where the scene names a measured BRDF: error over directions, and the memory that paint is looked up in.
    void measure(Gpu& gpu, glm::uvec2, nlohmann::json& error) override {
        CarPaint& paint = world.objects.paint;
        if (!paint.is_given()) return;
        error["directions"] = direction_error(gpu, paint);
        error["bytes"] = paint.bytes();
    }
};

CHAPTER(EnvironmentChapter)
