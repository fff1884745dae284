// right
#include "07_mipmaps/exercises.h"

namespace lightwalk::exercise {

std::vector<glm::uvec2> level_sizes(glm::uvec2 size) {
    std::vector<glm::uvec2> sizes;
    uint32_t level = 0;
    do sizes.push_back({std::max(size.x >> level, 1u), std::max(size.y >> level, 1u)});
    while (sizes.back() != glm::uvec2(1) && ++level);
    return sizes;
}

}  // namespace lightwalk::exercise
