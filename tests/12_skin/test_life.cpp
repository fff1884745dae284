// Motion of the chapter's modules.
#include "../common/scene_fixture.h"
#include "12_skin/head.h"
#include "catch.h"

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
