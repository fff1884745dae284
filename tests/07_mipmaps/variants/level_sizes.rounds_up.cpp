// wrong: level_sizes(1x7): after 1x7 came 1x4, expected 1x3
#include "07_mipmaps/exercises.h"

namespace lightwalk::exercise {

std::vector<glm::uvec2> level_sizes(glm::uvec2 size) {
    std::vector<glm::uvec2> sizes{size};
    while (sizes.back() != glm::uvec2(1)) sizes.push_back((sizes.back() + 1u) / 2u);
    return sizes;
}

}  // namespace lightwalk::exercise
