// For checks of 10.place_at: a struct is the last of a probe's parameters.
#include "10_atmosphere/air.glsl"

Place place_at(float t, Path path) { return place_at(path, t); }
