// Cached results are remade after any change of their inputs: the picture is that of a cold start.
#include "common/base/toggle_scope.h"
#include "volume_fixture.h"

using namespace lightwalk;

namespace {

struct OnNebula : OnVolume {
    OnNebula() {
        volume.method.set("skipping");
        volume.light.set("volume");
        volume.wave.value = 0.05f;
    }
};

/// The picture after `change`, with another one drawn before it or none.
template <class Change>
ImageRgb after(const Change& change, bool warm) {
    OnNebula on;
    if (warm) on.draw(1);
    change(on);
    return on.picture(1);
}

template <class Change>
void is_seen(const Change& change) {
    const ImageRgb cold = after(change, false);
    CHECK(mean_difference(after(change, true), cold) == 0);
    CHECK(mean_difference(after([](OnNebula&) {}, false), cold) > 1e-5);
}

}  // namespace

TEST_CASE("a knob that changes while it runs gives the picture of a cold start") {
    is_seen([](OnNebula& on) { on.volume.wave_speed.value = 3; });
    is_seen([](OnNebula& on) { on.volume.light_steps.value = 4; });
    is_seen([](OnNebula& on) { on.volume.light_from.set("sun"); });
    is_seen([](OnNebula& on) { on.volume.density.value = 3; });
}

TEST_CASE("a sun that moves from behind to before the volume gives the picture of a cold start") {
    const auto lit_from = [](float z, bool warm) {
        OnNebula on;
        on.volume.light_from.set("sun");
        const auto stand = [&](float at) {
            on.scene.set_sun({glm::normalize(glm::vec3(0.3f, 0.4f, at)), glm::vec3(2)});
        };
        stand(-1);
        if (warm) on.draw(1);
        stand(z);
        return on.picture(1);
    };
    const ImageRgb cold = lit_from(1, false);
    CHECK(mean_difference(lit_from(1, true), cold) == 0);
    CHECK(mean_difference(lit_from(-1, false), cold) > 1e-5);
}

TEST_CASE("an exercise that is toggled while it runs gives the picture of a cold start") {
    for (const char* id : {"16.correct_opacity", "16.skip_empty"}) {
        INFO(id);
        const auto toggled = [&](bool warm) {
            OnNebula on;
            if (warm) on.draw(1);
            const ToggleScope mine({id}, false);
            on.draw(1);
            return std::pair{read_linear(on.gpu, on.frame.hdr), on.gpu.read_back(on.volume.blocks())};
        };
        const auto cold = toggled(false), warm = toggled(true);
        CHECK(mean_difference(warm.first, cold.first) == 0);
        CHECK(warm.second == cold.second);
    }
}
