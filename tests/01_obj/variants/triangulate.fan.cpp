// wrong: wound the other way
#include "01_obj/exercises.h"

namespace lightwalk::exercise {

std::vector<glm::uvec3> triangulate(std::span<const glm::vec3> polygon) {
    std::vector<glm::uvec3> triangles;
    for (uint32_t i = 2; i < polygon.size(); ++i) triangles.push_back({0, i - 1, i});
    return triangles;
}

}  // namespace lightwalk::exercise
