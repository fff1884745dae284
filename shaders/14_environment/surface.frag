// A surface in the light of its surroundings, of which nothing is hidden.
#include "14_environment/surface.glsl"
#include "14_environment/unoccluded.glsl"
