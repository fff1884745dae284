// Phase function of the volume: share of scattered light per steradian.
#include "common/henyey_greenstein.glsl"

// `cosine` of the angle by which light is turned: 1 if it goes on as before. `g`: the mean cosine.
float phase(float cosine, float g) { return henyey_greenstein(cosine, g, 0.25 / 3.14159265); }
