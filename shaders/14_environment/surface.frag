// A surface in the light of its surroundings. For what rays find hidden, occluded.glsl is read in place of unoccluded.glsl.
#include "14_environment/surface.glsl"
#include "14_environment/unoccluded.glsl"
