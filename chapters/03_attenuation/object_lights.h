// Lists of the lights that may reach each draw call of a scene.
#pragma once
#include "03_attenuation/light_buffer.h"
#include "common/base/epoch.h"
#include "common/scene/scene.h"

namespace lightwalk {

/// Light lists of draw calls, built on the CPU. Independent of the camera; rebuilt if the lights, the scene's parts,
/// the threshold or the exercise's toggle change.
class ObjectLights {
  public:
    /// `threshold`: see influence_radius(). Uploads new lists.
    void update(Frame& frame, const Scene& scene, const LightBuffer& lights, float threshold);

    Buffer ends;    ///< end of each draw call's list in `lights`
    Buffer lights;  ///< indices into the LightBuffer, ascending in each list

  private:
    Fingerprint made_;
};

}  // namespace lightwalk
