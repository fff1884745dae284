// Whether the chapter's modules move, and the changes that reload its scene.
#include "../common/scene_fixture.h"
#include "12_skin/head.h"
#include "catch.h"
#include "common/base/exercise.h"

using namespace lightwalk;

namespace {

struct Modules : NoChapter {
    LitScene objects{*this, "objects"};
    EnvironmentLight environment{*this, "environment"};
    Head head{*this, "head", objects, environment};
};

}  // namespace

TEST_CASE("a head whose maps swing or flow moves") {
    Modules modules;
    CHECK_FALSE(modules.any_animated());
    modules.objects.maps.wobble.value = 0.1f;
    CHECK(modules.any_animated());
    modules.objects.maps.wobble.value = 0;
    modules.objects.maps.scroll.value = 0.1f;
    CHECK(modules.any_animated());
}

TEST_CASE("toggling an exercise that runs while a scene is loaded loads a head's scene again") {
    Modules modules;
    const std::string before = modules.load_state();
    Exercises::set("04.tangent_frame", false);
    CHECK(modules.load_state() != before);
    CHECK(modules.loads_exercise());
    Exercises::use("solution");
    CHECK(modules.load_state() == before);
}
