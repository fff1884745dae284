// Exercise 08.pair_taps: one read for two neighbouring pixels.
// Starter: each pixel is read by itself: the result is right, for twice the work.
#include "08_bloom/exercises.h"

namespace lightwalk::exercise {

// [pair_taps]
// `weights` holds the weights of the pixels at the distances 0, 1, 2 ... R to one side,
// none below 0. Returns taps (offset in pixels, weight) for a linear filter: a read at
// the offset k + f, with f from 0 to 1, returns (1 - f) times pixel k plus f times
// pixel k + 1.
//
// The first tap is pixel 0 alone. The following pixels form pairs, 1 with 2, 3 with 4
// and so on, each replaced by a single tap that gives both pixels their weights, within
// a millionth. A pixel left over at the end is a tap of its own. There are
// 1 + ceil(R / 2) taps. Weights may be 0. If both weights of a pair are 0, the tap has
// the weight 0 and any offset between the two pixels, but not NaN.
// [/pair_taps]
std::vector<glm::vec2> pair_taps(const std::vector<float>& weights) {
    std::vector<glm::vec2> taps;
    for (size_t k = 0; k < weights.size(); ++k) taps.emplace_back(static_cast<float>(k), weights[k]);
    return taps;
}

}  // namespace lightwalk::exercise
