// Light in linear numbers with Rec. 709 primaries: how bright it is, and what a target of half floats holds of it.
#include "common/structs.h"

float luminance(vec3 radiance) { return dot(radiance, vec3(0.2126, 0.7152, 0.0722)); }

// Below 0 and NaN is 0, above the largest half and infinity is the largest half.
vec3 finite_light(vec3 radiance) { return mix(clamp(radiance, 0.0, LARGEST_HALF), vec3(0.0), isnan(radiance)); }
