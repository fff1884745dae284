// wrong: m³ are enough
#include <cmath>

#include "06_deferred/exercises.h"

namespace lightwalk::exercise {

LightVolume light_volume_bounds(const Light& light, float radius_m) {
    LightVolume volume;
    volume.to_world = glm::mat4(radius_m);
    volume.to_world[3] = glm::vec4(light.position, 1.0f);
    return volume;
}

}  // namespace lightwalk::exercise
