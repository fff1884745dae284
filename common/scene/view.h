// Viewpoint of a picture: a camera and the drawn part of its picture, or any matrix.
#pragma once
#include <map>
#include <optional>

#include "common/gpu/frame.h"
#include "common/scene/camera.h"
#include "common/structs.h"
#include "common/view_rays.h"

namespace lightwalk {

/// One view of a frame. camera_view() makes it of a camera; for a light's map the matrix and the eye are enough.
struct View {
    glm::mat4 view_projection{1.0f};  ///< world to clip space: y down, depth 1 near and 0 far
    glm::vec3 eye{0.0f};              ///< metres, world space
    Camera camera{};                  ///< stands at `eye`
    glm::uvec2 size{0};               ///< pixels that are drawn; 0: the frame's
    Crop crop{};                      ///< of which larger picture they are a part
    /// Where floats are too coarse: the eye in metres of the world that a drawing knows in double precision. `eye` and the
    /// camera then stand at the origin, and directions are that world's.
    std::optional<glm::dvec3> exact_eye{};
    uint32_t id = 0;       ///< 0: the frame's own; histories are kept per id
    bool sun_disc = true;  ///< false: the caller adds the reflection of the sun's disc

    /// The angle of a pixel in the middle of the whole picture, in radians.
    float pixel_rad() const;
};

/// Ids of views that one owner makes of others: the same for the same view and part, and no other owner's.
class DerivedViews {
  public:
    uint32_t of(uint32_t id, uint32_t part = 0);

  private:
    std::map<std::pair<uint32_t, uint32_t>, uint32_t> ids_;
};

/// The camera's view, `size` pixels of it. `world_to_clip` is the camera's, for the whole picture of `crop.whole`
/// pixels (0: `size`).
View camera_view(const Camera& camera, const glm::mat4& world_to_clip, glm::uvec2 size, Crop crop = {});

/// The rays through the pixels of a camera's view.
ViewRays view_rays(const View& view);

/// The uniform block `view` of shaders.
CameraView shader_view(const View& view, const Frame& frame);

/// Gives the shaders of all passes that follow the block `view`. One pass alone: pass.set("view", shader_view(...)).
void look_from(const View& view, Frame& frame);

/// Does so while it lives, and then restores the view that was there before.
class ViewScope {
  public:
    ViewScope(Frame& frame, const View& view);
    ~ViewScope();
    ViewScope(const ViewScope&) = delete;

  private:
    Frame& frame_;
    std::vector<std::byte> before_;
};

/// From the clip space of a whole picture to that of its part of `size` pixels. Multiply from the left.
glm::mat4 part_of(const Crop& crop, glm::uvec2 size);

}  // namespace lightwalk
