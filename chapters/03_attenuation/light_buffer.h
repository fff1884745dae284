// Storage buffer with all lights of a scene, in the form that shaders read.
#pragma once
#include "03_attenuation/light_data.h"
#include "common/gpu/frame.h"
#include "common/scene/light.h"

namespace lightwalk {

LightData pack(const Light& light);

// [light_buffer]
/// Lights in the scene's order, packed and uploaded again when one has changed.
class LightBuffer {
  public:
    /// Uploads the lights if they have changed; true if so.
    bool update(Frame& frame, const LightList& lights);
    bool update(Frame& frame, const std::vector<Light>& lights);

    Buffer buffer;     ///< bound as `lights`; empty before update()
    int rebuilds = 0;  ///< number of times packed
    const std::vector<Light>& lights() const { return *lights_; }
    const LightList& list() const { return lights_; }  ///< replaced after each change

  private:
    LightList lights_ = std::make_shared<std::vector<Light>>();
};
// [/light_buffer]

}  // namespace lightwalk
