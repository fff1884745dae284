#include <algorithm>
#include <cmath>

#include "16_volume/exercises.h"

namespace lightwalk::solution {
namespace {

glm::vec4 entry_at(std::span<const glm::vec4> transfer, float density) {
    const float at = std::clamp(density, 0.0f, 1.0f) * static_cast<float>(transfer.size() - 1);
    const size_t below = std::min(static_cast<size_t>(at), transfer.size() - 2);
    return glm::mix(transfer[below], transfer[below + 1], at - static_cast<float>(below));
}

}  // namespace

// K. Engel, M. Kraus and T. Ertl, "High-Quality Pre-Integrated Volume Rendering Using Hardware-Accelerated Pixel
// Shading", Graphics Hardware 2001: the integral of the transfer function along a step, cut into thin layers.
glm::vec4 preintegrate(std::span<const glm::vec4> transfer, float front, float back, float ratio) {
    // Four layers for each entry that is passed; more where a step is long, so that none of them hides much of itself.
    const float passed = std::abs(back - front) * static_cast<float>(transfer.size() - 1);
    const int layers = passed == 0 ? 1 : 16 + static_cast<int>(4 * passed) + static_cast<int>(8 * ratio);
    const float each = ratio / static_cast<float>(layers);
    glm::vec3 light(0.0f);
    float through = 1;
    for (int i = 0; i < layers && through > 1e-5f; ++i) {
        const float share = (static_cast<float>(i) + 0.5f) / static_cast<float>(layers);
        const glm::vec4 looks = entry_at(transfer, glm::mix(front, back, share));
        if (looks.a <= 0 || each <= 0) continue;
        const float opacity = looks.a >= 1 ? 1.0f : 1 - std::pow(1 - looks.a, each);
        light += through * opacity * glm::vec3(looks);
        through *= 1 - opacity;
    }
    return {light, 1 - through};
}

}  // namespace lightwalk::solution
