// What a picture is drawn from: a camera, a lamp, any matrix.
#pragma once
#include "common/gpu/frame.h"
#include "common/structs.h"

namespace lightwalk {

struct View {
    glm::mat4 view_projection{1.0f};  ///< world to clip space: y down, depth 1 near and 0 far
    glm::vec3 eye{0.0f};              ///< metres, world space
};

/// The uniform block `view` of shaders, for a picture of `size` pixels.
CameraView shader_view(const View& view, const Frame& frame, glm::uvec2 size);

/// Gives the shaders of all passes that follow the block `view`. One pass alone: pass.set("view", shader_view(...)).
void look_from(const View& view, Frame& frame);

/// From the clip space of a whole picture to that of its part of `size` pixels. Multiply from the left.
glm::mat4 part_of(const Crop& crop, glm::uvec2 size);

}  // namespace lightwalk
