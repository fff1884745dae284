// Noise that no exercise decides: how a kernel is turned, which rows are torn, where a tile of grain lies.
#include "05_shadow_maps/sampling.glsl"

// -1 to 1 (1 excluded), evenly distributed.
float noise_of(uvec2 place, uint time) { return float(seed_of(place, time) >> 8u) * (2.0 / 16777216.0) - 1.0; }
