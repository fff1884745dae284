// wrong: level_sizes(1x7): the last level is
#include "07_mipmaps/exercises.h"

namespace lightwalk::exercise {

std::vector<glm::uvec2> level_sizes(glm::uvec2 size) {
    std::vector<glm::uvec2> sizes{size};
    while (sizes.back().x > 1 && sizes.back().y > 1) sizes.push_back(sizes.back() / 2u);
    return sizes;
}

}  // namespace lightwalk::exercise
