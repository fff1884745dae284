// For tests of the glass shell: noise that changes along the radius alone, or evenly along x; surroundings that are their
// own direction, or white.
#pragma replaces "16_volume/noise_methods.glsl"
#pragma replaces "16_volume/surroundings.glsl"
#include "16_volume/volume_data.h"

struct CheckKnownShell {
    float shell_strength, shell_bumps, shell_scale;
};
struct CheckKnownVolume {
    float radius_m;
    NoiseMoment moment;
};
const CheckKnownShell volume = CheckKnownShell(1.0, 2.0, 3.0);
const CheckKnownVolume volume_now = CheckKnownVolume(1.0, NoiseMoment(0, 0.0, 0, 0.0, 0));

#ifdef EVEN_SLOPE
float moving_noise(vec3 at, NoiseMoment moment) { return EVEN_SLOPE * at.x; }
#else
float moving_noise(vec3 at, NoiseMoment moment) { return length(at); }
#endif
#ifdef WHITE_SURROUNDINGS
vec3 surroundings(vec3 direction) { return vec3(1.0); }
#else
vec3 surroundings(vec3 direction) { return direction; }
#endif
