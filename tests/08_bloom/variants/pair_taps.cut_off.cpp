// wrong: taps, expected
#include "08_bloom/exercises.h"

namespace lightwalk::exercise {

std::vector<glm::vec2> pair_taps(const std::vector<float>& weights) {
    std::vector<glm::vec2> taps;
    if (weights.empty()) return taps;
    taps.emplace_back(0.0f, weights[0]);
    for (size_t k = 1; k < weights.size() && (weights[k] == 0.0f || weights[k] > 1e-7f); k += 2) {
        const float second = k + 1 < weights.size() ? weights[k + 1] : 0.0f, both = weights[k] + second;
        taps.emplace_back(static_cast<float>(k) + (both > 0.0f ? second / both : 0.0f), both);
    }
    return taps;
}

}  // namespace lightwalk::exercise
