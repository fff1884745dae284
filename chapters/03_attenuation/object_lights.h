// Lists of the lights that may reach each draw call of a scene.
#pragma once
#include "03_attenuation/light_buffer.h"
#include "common/base/epoch.h"
#include "common/scene/scene.h"

namespace lightwalk {

/// Light lists of all draw calls, made on the CPU. They do not depend on the camera, and are rebuilt if the lights, the
/// scene's parts, the threshold or the exercise's toggle change.
class ObjectLights {
  public:
    /// `threshold` is influence_radius()'s. Lists that are new are uploaded in passes of the frame.
    void update(Frame& frame, const Scene& scene, const LightBuffer& lights, float threshold);

    Buffer ends;    ///< where each draw call's list ends in `lights`
    Buffer lights;  ///< positions in the LightBuffer, ascending in each list

  private:
    Fingerprint made_;
};

}  // namespace lightwalk
