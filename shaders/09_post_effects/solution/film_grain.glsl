// Solution of 09.film_grain, by chapter 05's hash of three words.
#include "05_shadow_maps/sampling.glsl"

float film_grain(uvec2 pixel, uint frame) { return float(seed_of(pixel, frame) >> 8u) * (2.0 / 16777216.0) - 1.0; }
