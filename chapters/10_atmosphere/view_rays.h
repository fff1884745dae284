// The rays through a picture's pixels.
#pragma once
#include "10_atmosphere/view_rays_shared.h"
#include "common/gpu/frame.h"
#include "common/scene/camera.h"

namespace lightwalk {

/// Of what the camera sees in this frame: a part of a picture, shifted within a pixel.
ViewRays view_rays(const Camera& camera, const Frame& frame);

}  // namespace lightwalk
