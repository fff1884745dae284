// A surface in the light of its surroundings, as far as rays find nothing in the way.
#include "14_environment/surface.glsl"
#include "14_environment/occluded.glsl"
