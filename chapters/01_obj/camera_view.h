// View of a camera, by this chapter's matrix.
#pragma once
#include "01_obj/exercises.h"
#include "common/app/world.h"
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

/// Places moving objects in the scene, and sets this frame's uniform block `view`: the given camera's view, unless
/// the world has a camera of its own.
inline View look_at(World& world, Frame& frame, Scene& scene, const Camera& camera) {
    animate(scene, frame.time_s);
    scene.upload_moved(frame);
    const World::Eye eye = world.eye(frame, camera);
    View view = view_of(eye.camera, frame);
    view.exact_eye = eye.exact;
    look_from(view, frame);
    return view;
}

}  // namespace lightwalk
