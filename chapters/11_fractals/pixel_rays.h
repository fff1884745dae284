// Rays through pixels, for passes that have no triangles.
#pragma once
#include "11_fractals/julia_data.h"
#include "common/gpu/frame.h"
#include "common/scene/camera.h"

namespace lightwalk {

/// Those of a frame: of its crop, and shifted within a pixel as its sample says.
PixelRays pixel_rays(const Camera& camera, const Frame& frame);

}  // namespace lightwalk
