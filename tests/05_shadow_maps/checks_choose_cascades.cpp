// What ./course check runs for 05.choose_cascades: the widest texel that is seen, and the maps' memory.
#include <cmath>

#include "05_shadow_maps/truth.h"
#include "common/check/choice.h"

using namespace lightwalk;

namespace {

ChoiceScene scene(const std::string& name, double near_m, double far_m, double seen_from_m, double most_px,
                  double most_mib) {
    return {name, most_px, most_mib, [=](std::span<const int> knobs) -> ErrorAndCost {
                const int count = knobs[0], size = knobs[1];
                if (size & (size - 1)) return {.unusable = "a size is 512, 1024, 2048 or 4096"};
                double widest_px = 0;
                for (int i = 0; i < count; ++i) {
                    const auto split = [&](int k) {
                        return k == 0 ? near_m : truth::cascade_split(near_m, far_m, k, count, knobs[2] / 100.0);
                    };
                    const double nearest_m = std::max(split(i), seen_from_m);
                    if (split(i + 1) > nearest_m)
                        widest_px = std::max(widest_px, split(i + 1) / nearest_m * 1080 / size);
                }
                return {.error = widest_px, .cost = 4.0 * count * size * size / (1024 * 1024)};
            }};
}

}  // namespace

CHECK_EXERCISE("05.choose_cascades", "A cascade's worst place is its near end: how many times as far is its far end?") {
    check_choice(check,
                 {.include = "05_shadow_maps/choose_cascades.glsl",
                  .signature = "ivec3 choose_cascades(int scene)",
                  .knobs = {{"the number of cascades", 1, 4}, {"a size", 512, 4096}, {"lambda in percent", 0, 100}},
                  .error_unit = " pixels",
                  .cost_unit = "MiB",
                  .scenes = {scene("the cellar", 0.1, 100, 0.1, 8, 16), scene("the valley", 1, 2000, 50, 4, 16),
                             scene("the room", 1, 20, 1, 5, 8)}});
}
