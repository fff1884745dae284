// For checks of 10.in_scatter: sunlight by marching in 24 steps, and no light before.
#include "10_atmosphere/sun_marched.glsl"
#include "10_atmosphere/in_scatter.glsl"

int light_steps() { return 24; }
bool light_steps_grow() { return true; }
