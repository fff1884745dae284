// For tests of the glass shell: noise that changes along the radius alone, or evenly along x; surroundings that are their
// own direction, or white.
#pragma replaces "16_volume/noise_methods.glsl"
#pragma replaces "16_volume/surroundings.glsl"
#include "16_volume/volume_data.h"

struct KnownShell {
    float shell_strength, shell_bumps, shell_scale;
};
struct KnownVolume {
    float radius_m;
    NoiseMoment moment;
};
const KnownShell volume = KnownShell(1.0, 2.0, 3.0);
const KnownVolume volume_now = KnownVolume(1.0, NoiseMoment(0, 0.0, 0, 0.0, 0));

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
