// The depth used for moments, and the absorbance they measure.
#include "15_terrain_water/transparency_data.h"

layout(scalar) uniform TransparencyNowBlock { TransparencyNow transparency_now; };

// From -1 to 1, evenly in the logarithm of the distance along the view.
float moment_depth() {
    float near_m = transparency_now.near_m, far_m = transparency_now.far_m;
    float distance_m = clamp(1.0 / gl_FragCoord.w, near_m, far_m);
    return 2.0 * log(distance_m / near_m) / log(far_m / near_m) - 1.0;
}

// An alpha of 1 has infinite absorbance; 2^-20 remains.
float absorbance_of(float alpha) { return -log(max(1.0 - alpha, 9.5e-7)); }
