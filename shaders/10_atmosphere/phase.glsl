// Which way light goes that is scattered: shares per steradian, whose integral over all directions is 1.
#include "10_atmosphere/phase_mie.glsl"
#include "10_atmosphere/phase_rayleigh.glsl"

// L. G. Henyey and J. L. Greenstein, Astrophysical Journal 93, 1941, p. 77; its mean cosine is g.
float phase_henyey_greenstein(float cos_angle, float g) {
    float b = 1.0 + g * g - 2.0 * g * cos_angle;
    return 0.25 / 3.14159265 * (1.0 - g * g) / (b * sqrt(b));
}

float phase_dust(float cos_angle, float g) {
#if ATMOSPHERE_PHASE == ATMOSPHERE_PHASE_ISOTROPIC
    return 0.25 / 3.14159265;
#elif ATMOSPHERE_PHASE == ATMOSPHERE_PHASE_HENYEY_GREENSTEIN
    return phase_henyey_greenstein(cos_angle, g);
#else
    return phase_mie(cos_angle, g);
#endif
}
