#include <algorithm>
#include <numeric>

#include "15_terrain_water/exercises.h"

namespace lightwalk::solution {

std::vector<uint32_t> sort_back_to_front(const std::vector<glm::vec3>& middles, glm::vec3 eye) {
    std::vector<float> distances;
    for (const glm::vec3& middle : middles) distances.push_back(glm::length(middle - eye));
    std::vector<uint32_t> order(middles.size());
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) { return distances[a] > distances[b]; });
    return order;
}

}  // namespace lightwalk::solution
