// Chapter 17: the Sun, its planets, and one moon, as their photographs show them.
#include "09_post_effects/finished_chapter.h"
#include "17_planets/solar_system.h"

using namespace lightwalk;

struct PlanetsChapter : FinishedChapter<SolarSystem> {
    PlanetsChapter() {
        world.planets.method.preferred = true;  // --method is about the law here
    }
    std::string default_scene() const override { return "scenes/saturn.json"; }
};

CHAPTER(PlanetsChapter)
