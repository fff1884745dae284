// A surface in the light of its surroundings. For occlusion by rays, occluded.glsl replaces unoccluded.glsl.
#include "14_environment/surface.glsl"
#include "14_environment/unoccluded.glsl"
