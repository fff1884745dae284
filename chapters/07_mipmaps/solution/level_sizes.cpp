// Solution of 07.level_sizes.
#include "07_mipmaps/exercises.h"

namespace lightwalk::solution {

std::vector<glm::uvec2> level_sizes(glm::uvec2 size) {
    std::vector<glm::uvec2> sizes{size};
    while (sizes.back() != glm::uvec2(1)) sizes.push_back(glm::max(sizes.back() / 2u, glm::uvec2(1)));
    return sizes;
}

}  // namespace lightwalk::solution
