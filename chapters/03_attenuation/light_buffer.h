// Storage buffer with all lights of a scene, in the form that shaders read.
#pragma once
#include "03_attenuation/light_data.h"
#include "common/gpu/frame.h"
#include "common/scene/light.h"

namespace lightwalk {

LightData pack(const Light& light);

// [light_buffer]
/// Holds as many lights as there are, in their order, and is packed and uploaded again only when one has changed.
class LightBuffer {
  public:
    /// Adds an upload pass to the frame if the lights have changed; true in this case.
    bool update(Frame& frame, const LightList& lights);
    bool update(Frame& frame, const std::vector<Light>& lights);

    Buffer buffer;     ///< bound as `lights`; empty before update()
    int rebuilds = 0;  ///< how often it was packed
    const std::vector<Light>& lights() const { return *lights_; }
    const LightList& list() const { return lights_; }  ///< another one after each change

  private:
    LightList lights_ = std::make_shared<std::vector<Light>>();
};
// [/light_buffer]

}  // namespace lightwalk
