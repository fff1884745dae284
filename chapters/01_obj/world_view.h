// View of a world, by this chapter's matrix.
#pragma once
#include "01_obj/camera_view.h"
#include "common/app/world.h"

namespace lightwalk {

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
