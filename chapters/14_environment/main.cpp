// Chapter 14: light from all around, out of a picture or out of the scene itself.
#include "09_post_effects/finished_chapter.h"
#include "14_environment/surroundings.h"

using namespace lightwalk;

struct EnvironmentChapter : FinishedChapter<Surroundings> {
    EnvironmentChapter() {
        world.light.method.preferred = true;  // --method is about reflections here
    }
    std::string default_scene() const override { return "scenes/lacquered_statue.json"; }
};

CHAPTER(EnvironmentChapter)
