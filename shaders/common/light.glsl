// Linear light with Rec. 709 primaries: luminance, and the range of half floats.
#include "common/structs.h"

float luminance(vec3 radiance) { return dot(radiance, vec3(0.2126, 0.7152, 0.0722)); }

// Clamped to the range of halves; NaN becomes 0.
vec3 finite_light(vec3 radiance) { return mix(clamp(radiance, 0.0, LARGEST_HALF), vec3(0.0), isnan(radiance)); }
