// wrong: through the filter
#include <cmath>

#include "08_bloom/exercises.h"

namespace lightwalk::exercise {

std::vector<glm::vec2> pair_taps(const std::vector<float>& weights) {
    std::vector<glm::vec2> taps{{0.0f, weights[0]}};
    size_t k = 1;
    for (; k + 1 < weights.size(); k += 2) {
        const float a = weights[k], b = weights[k + 1];
        taps.push_back({k + (a + b > 0 ? b / (a + b) : 0), a + b});
    }
    return taps;
}

}  // namespace lightwalk::exercise
