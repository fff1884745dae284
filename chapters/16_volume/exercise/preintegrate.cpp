// Exercise 16.preintegrate: a whole step through the transfer function, ahead of time.
// As it stands a step looks like the density at its front alone, and thin layers fall between the samples.
#include <algorithm>
#include <cmath>

#include "16_volume/exercises.h"

namespace lightwalk::exercise {

// [preintegrate]
// A step along which the density changes evenly from `front` (at its near end) to `back`, both 0 to 1. `transfer` has at
// least 2 entries: entry i of n belongs to the density i / (n - 1), and between two of them colour and opacity are mixed
// linearly. An entry is (r, g, b, a): a is the opacity of a layer of the reference length, which shines with `a` times the
// colour. The step is `ratio` reference lengths long (0 to 100). Returns what the step adds to a picture with nothing
// before it (r, g, b: near parts weaken far ones) and its whole opacity (a). Colours may be above 1.
//
// Right within 0.002 of the greatest colour for any transfer function, be it a single entry that is not 0: cut the step at
// least once for each entry that the density passes, and where those cuts are still so opaque that the order within one
// matters. Equal densities are one layer, of which one cut says everything. The table of all pairs (256 x 256) must take
// less than a few seconds.
// [/preintegrate]
glm::vec4 preintegrate(std::span<const glm::vec4> transfer, float front, float back, float ratio) {
    (void)back;
    const auto entry = static_cast<size_t>(front * static_cast<float>(transfer.size() - 1));
    const glm::vec4 looks = transfer[std::min(entry, transfer.size() - 1)];
    const float opacity = 1.0f - std::pow(1.0f - std::min(looks.a, 0.9999f), ratio);
    return {looks.r * opacity, looks.g * opacity, looks.b * opacity, opacity};
}

}  // namespace lightwalk::exercise
