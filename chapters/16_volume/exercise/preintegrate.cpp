// Exercise 16.preintegrate: a whole step through the transfer function, ahead of time.
// Starter: a step looks like the density at its front alone, and thin layers fall between the samples.
#include <algorithm>
#include <cmath>

#include "16_volume/exercises.h"

namespace lightwalk::exercise {

// [preintegrate]
// Returns the light (rgb) and the opacity (a) of one step of a ray. Along the step the
// density changes linearly from `front`, at the end nearer to the camera, to `back`; both
// are 0 to 1. The light is what the step adds to a picture with nothing in front of it: the
// near part of the step attenuates the far part.
//
// - `transfer` is the transfer function, n >= 2 entries. Entry i belongs to the density
//   i / (n - 1); between two entries, colour and opacity are interpolated linearly.
// - An entry is (r, g, b, a). A layer of the reference length absorbs the fraction a of the
//   light from behind and emits a times the colour. Colours may be above 1.
// - `ratio` is the length of the step in reference lengths, 0 to 100.
//
// The result must be right to 0.002 of the greatest colour for every transfer function, even
// for one with a single entry that is not 0. Cut the step at every density that has an
// entry. Cut these pieces further as long as one of them is so opaque that the order of
// light and absorption within it matters. Where front and back are equal, one piece is
// exact. A table of 256 x 256 pairs must take less than 20 seconds.
// [/preintegrate]
glm::vec4 preintegrate(std::span<const glm::vec4> transfer, float front, float back, float ratio) {
    (void)back;
    const auto entry = static_cast<size_t>(front * static_cast<float>(transfer.size() - 1));
    const glm::vec4 looks = transfer[std::min(entry, transfer.size() - 1)];
    const float opacity = 1.0f - std::pow(1.0f - std::min(looks.a, 0.9999f), ratio);
    return {looks.r * opacity, looks.g * opacity, looks.b * opacity, opacity};
}

}  // namespace lightwalk::exercise
