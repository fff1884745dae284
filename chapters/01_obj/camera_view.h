// View of a camera, by this chapter's matrix.
#pragma once
#include "01_obj/exercises.h"
#include "common/scene/view.h"

namespace lightwalk {

/// In a picture of `size` pixels, or in the part of one that `crop` says.
inline View view_of(const Camera& camera, glm::uvec2 size, Crop crop = {}) {
    if (crop.whole == glm::uvec2(0)) crop.whole = size;
    const glm::vec2 whole(crop.whole);
    return camera_view(camera, view_projection(camera, whole.x / whole.y), size, crop);
}

/// In this frame's picture.
inline View view_of(const Camera& camera, const Frame& frame) { return view_of(camera, frame.size, frame.crop); }

}  // namespace lightwalk
