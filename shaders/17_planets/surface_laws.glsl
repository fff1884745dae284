// Reflection of sunlight by a body's surface, by each law, relative to a surface of the same albedo with the sun and
// the camera overhead: each is 1 there.
#include "17_planets/body_data.h"
#include "17_planets/lommel_seeliger.glsl"
#include "common/henyey_greenstein.glsl"

// B. Hapke, "Bidirectional reflectance spectroscopy. 1. Theory", Journal of Geophysical Research 86(B4), 1981, with the
// opposition surge of part 4 (Icarus 67, 1986); no large-scale roughness. The reference for airless surfaces.

// Single-scattering albedo, a Henyey-Greenstein function that sends light back, and a surge of half width h. Chosen so that a
// ball of it has the Moon's brightness at half phase; the lesson says how near.
const float hapke_w = 0.28, hapke_back = 0.24, hapke_h = 0.06, hapke_surge = 1.0;

float hapke_h_function(float mu) { return (1.0 + 2.0 * mu) / (1.0 + 2.0 * mu * sqrt(1.0 - hapke_w)); }

// Radiance over that of a white Lambertian surface that faces the sun; 0 where the sun or the camera is below the horizon.
float hapke_radiance(float mu0, float mu, float cos_phase) {
    if (mu0 <= 0.0 || mu <= 0.0) return 0.0;
    float half_tangent = sqrt(max(1.0 - cos_phase, 0.0) / max(1.0 + cos_phase, 1e-6));
    float surge = hapke_surge / (1.0 + half_tangent / hapke_h);
    float once = henyey_greenstein(cos_phase, hapke_back, 1.0);
    float often = hapke_h_function(mu0) * hapke_h_function(mu) - 1.0;
    return 0.25 * hapke_w * mu0 / (mu0 + mu) * ((1.0 + surge) * once + often);
}

// [laws]
// Light that reaches past n·l = 0, down to -w; 1 where the sun is overhead.
float wrapped_terminator(float cosine, float w, float k) {
    float lit = (cosine + w) / (1.0 + w);
    return lit > 0.0 ? pow(lit, k) : 0.0;
}

// M. Minnaert, Astrophysical Journal 93, 1941: µ0^k µ^(k - 1). Below k = 1 it has no bound at the limb: µ is at least 0.04.
float minnaert(float mu0, float mu, float k) {
    return mu0 > 0.0 ? pow(mu0, k) * pow(clamp(mu, 0.04, 1.0), k - 1.0) : 0.0;
}

// `cosine` is n·l, also below 0; mu0 and mu are 0 or more.
float reflected_by(int law, SurfaceLaw surface, float cosine, float mu, float cos_phase) {
    float mu0 = max(cosine, 0.0);
    if (law == LAW_WRAPPED) return wrapped_terminator(cosine, surface.wrap, surface.wrap_power);
    if (law == LAW_LOMMEL_SEELIGER) return lommel_seeliger(mu0, mu);
    if (law == LAW_MINNAERT) return minnaert(mu0, mu, surface.minnaert);
    if (law == LAW_HAPKE) return hapke_radiance(mu0, mu, cos_phase) / hapke_radiance(1.0, 1.0, 1.0);
    return mu0;
}
// [/laws]

// A white sky seen by a place of albedo 1 towards mu, above 0: the law's integral over the directions of light. A law's albedo
// is that seen from overhead, so this may be above 1. Hapke's is below 1 where mu is above 0.02.
float sent_of_white_sky(int law, SurfaceLaw surface, float mu) {
    if (law == LAW_WRAPPED) return 2.0 * (1.0 + surface.wrap) / (1.0 + surface.wrap_power);
    if (law == LAW_LOMMEL_SEELIGER) return 4.0 - 4.0 * mu * log(1.0 + 1.0 / mu);
    if (law == LAW_MINNAERT) return 2.0 / (1.0 + surface.minnaert) * minnaert(1.0, mu, surface.minnaert);
    return 1.0;
}

// Light of a place, in that of a white one that faces the sun. Albedo is bounded, all colours alike, so that no more is
// sent than arrives.
vec3 reflected(SurfaceLaw surface, vec3 albedo, float cosine, float mu, float cos_phase) {
    int law = PLANETS_METHOD == PLANETS_METHOD_OWN ? surface.law : PLANETS_METHOD;  // numbered as the knob's values
    float most = max(albedo.r, max(albedo.g, albedo.b)) * sent_of_white_sky(law, surface, mu);
    return albedo / max(most, 1.0) * reflected_by(law, surface, cosine, mu, cos_phase);
}
