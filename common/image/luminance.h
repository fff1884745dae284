// Luminance of linear light.
#pragma once
#include <glm/glm.hpp>

namespace lightwalk {

/// Luminance of linear Rec. 709 RGB, in the unit of the channels.
template <class T>
T luminance(const glm::vec<3, T>& color) {
    return glm::dot(color, glm::vec<3, T>(0.2126, 0.7152, 0.0722));
}

}  // namespace lightwalk
