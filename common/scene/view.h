// Views: cameras or arbitrary projections, with the drawn part of the picture.
#pragma once
#include <map>
#include <optional>

#include "common/gpu/frame.h"
#include "common/scene/camera.h"
#include "common/structs.h"
#include "common/view_rays.h"

namespace lightwalk {

/// View of a frame, from camera_view() or, for shadow maps, with matrix and eye only.
struct View {
    glm::mat4 view_projection{1.0f};  ///< world to clip space: y down, depth 1 near and 0 far
    glm::vec3 eye{0.0f};              ///< metres, world space
    Camera camera{};
    glm::uvec2 size{0};  ///< pixels; 0: the frame's
    Crop crop{};
    /// Eye in double precision, metres, for planets; `eye` and `camera` are then at the origin.
    std::optional<glm::dvec3> exact_eye{};
    uint32_t id = 0;       ///< key of histories; 0: the frame's main view
    bool sun_disc = true;  ///< false: the caller adds the sun's reflection

    /// Angle of the picture's central pixel, in radians.
    float pixel_rad() const;
};

/// Unique, stable view ids derived from other views by one owner.
class DerivedViews {
  public:
    uint32_t of(uint32_t id, uint32_t part = 0);

  private:
    std::map<std::pair<uint32_t, uint32_t>, uint32_t> ids_;
};

/// Part of a camera's view, `size` pixels. `world_to_clip` is for the whole picture, `crop.whole` pixels (0: `size`).
View camera_view(const Camera& camera, const glm::mat4& world_to_clip, glm::uvec2 size, Crop crop = {});

ViewRays view_rays(const View& view);

/// Uniform block `view` of shaders.
CameraView shader_view(const View& view, const Frame& frame);

/// Sets the block `view` for all subsequent passes. For one pass only: pass.set("view", shader_view(...)).
void look_from(const View& view, Frame& frame);

/// Sets the block `view` within a scope, then restores it.
class ViewScope {
  public:
    ViewScope(Frame& frame, const View& view);
    ~ViewScope();
    ViewScope(const ViewScope&) = delete;

  private:
    Frame& frame_;
    std::vector<std::byte> before_;
};

/// Maps clip space of the whole picture to that of a part with `size` pixels. Multiply from the left.
glm::mat4 part_of(const Crop& crop, glm::uvec2 size);

}  // namespace lightwalk
