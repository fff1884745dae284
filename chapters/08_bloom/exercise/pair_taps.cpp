// Exercise 08.pair_taps: two neighbours for one read.
// As it stands each neighbour is read by itself: right, and twice the work.
#include "08_bloom/exercises.h"

namespace lightwalk::exercise {

// [pair_taps]
// `weights` are those of pixels 0, 1, 2 ... R to one side, none below 0. Returns taps (offset in pixels, weight) that a
// linear filter reads: at the offset k + f it gives (1 - f) of pixel k and f of pixel k + 1. The first tap is pixel 0
// alone; after it pixels go in pairs, 1 with 2, 3 with 4 ..., and one that is left over stands alone: 1 + ceil(R / 2)
// taps. Read through the filter and weighted, they give every pixel its weight, within a millionth. Weights may be 0,
// both of a pair too: the offset then lies between the two, and is no NaN.
// [/pair_taps]
std::vector<glm::vec2> pair_taps(const std::vector<float>& weights) {
    std::vector<glm::vec2> taps;
    for (size_t k = 0; k < weights.size(); ++k) taps.emplace_back(static_cast<float>(k), weights[k]);
    return taps;
}

}  // namespace lightwalk::exercise
