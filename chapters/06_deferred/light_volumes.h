// Light volumes: spheres and cones around the reach of lights.
#pragma once
#include "03_attenuation/lights.h"
#include "06_deferred/exercises.h"
#include "06_deferred/light_volume_data.h"
#include "common/base/epoch.h"

namespace lightwalk {

/// Corners of triangles, counter-clockwise from outside, three by three. The unit shape lies wholly within.
std::vector<glm::vec3> volume_mesh(LightVolume::Shape shape);

// [light_volumes]
class LightVolumes {
  public:
    /// Transfers of this frame where the lights, how far they reach, or the exercise's toggle have changed.
    void update(Frame& frame, const Lights& lights);

    /// Draws each light's volume: the pipeline in use reads `corners` and `volumes`.
    void draw(Raster& pass) const;

    Buffer without;  ///< how many lights reach everywhere, then which, ascending
    size_t count() const { return spheres_ + cones_; }

  private:
    Buffer sphere_, cone_, volumes_;  ///< spheres first, then cones
    uint32_t sphere_corners_ = 0, cone_corners_ = 0, spheres_ = 0, cones_ = 0;
    Fingerprint made_;
};
// [/light_volumes]

}  // namespace lightwalk
