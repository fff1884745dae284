// Uniform block of the mist.
#pragma once
#include "02_lambert_phong/mist.h"
#include "common/gpu/frame.h"
#include "common/scene/camera.h"

namespace lightwalk {

/// Gives the shaders of this frame the uniform block `mist`: `per_m` of extinction, and of that colour far away.
inline void set_mist(Frame& frame, float per_m, glm::vec3 color, const Camera& camera) {
    const Mist air{color, per_m, 0.4f * color * color, 1.0f / camera.near_m, 1.0f / camera.far_m};
    const auto bytes = std::as_bytes(std::span(&air, 1));
    frame.globals["mist"].assign(bytes.begin(), bytes.end());
}

}  // namespace lightwalk
