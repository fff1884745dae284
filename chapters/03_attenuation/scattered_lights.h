// Random lights over a scene; equal seeds give equal lights on every machine.
#pragma once
#include <vector>

#include "common/scene/light.h"
#include "common/scene/mesh.h"

namespace lightwalk {

/// `count` point and spot lights (every third one) a little above the bottom of `where`, in world space. The more there
/// are the shorter their range, so that about as many reach a point of the floor.
std::vector<Light> scatter_lights(const Bounds& where, int count, unsigned seed);

/// Takes each point and spot light around a circle of up to half a metre, in 2 s to 6 s. At time 0 it has moved, too.
void move_lights(std::vector<Light>& lights, float time_s);

}  // namespace lightwalk
