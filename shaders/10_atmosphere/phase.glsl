// Directions of scattered light: shares per steradian, with an integral of 1 over all directions.
#include "common/henyey_greenstein.glsl"
#include "10_atmosphere/phase_mie.glsl"
#include "10_atmosphere/phase_rayleigh.glsl"

float phase_henyey_greenstein(float cos_angle, float g) { return henyey_greenstein(cos_angle, g, 0.25 / 3.14159265); }

float phase_dust(float cos_angle, float g) {
#if ATMOSPHERE_PHASE == ATMOSPHERE_PHASE_ISOTROPIC
    return 0.25 / 3.14159265;
#elif ATMOSPHERE_PHASE == ATMOSPHERE_PHASE_HENYEY_GREENSTEIN
    return phase_henyey_greenstein(cos_angle, g);
#else
    return phase_mie(cos_angle, g);
#endif
}
