// Directional lights of a scene, in the form that shaders read.
#pragma once
#include "02_lambert_phong/directional_light.h"
#include "common/gpu/gpu.h"
#include "common/scene/light.h"

namespace lightwalk {

/// One entry for each directional light, in the scene's order; lights of other kinds are chapter 03's. At least one
/// entry, dark where the scene has none, because a buffer cannot be empty.
Buffer upload_directional_lights(Gpu& gpu, const std::vector<Light>& lights);

}  // namespace lightwalk
