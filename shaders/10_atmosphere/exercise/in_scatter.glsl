// Exercise 10.in_scatter: the light scattered into a path, and the transmittance of the path.
// Starter: air is clear and dark.
#include "10_atmosphere/phase.glsl"
#include "10_atmosphere/sunlight.glsl"

// [in_scatter]
// Returns Along(light, transmittance) of a path of path.way metres: the light scattered
// into it on the way, as it arrives at the start, and the fraction of light that passes
// the whole path.
//
// Divide the path into `samples` equal parts (1 or more). Each part is treated as
// uniform, with the properties of its middle. Available are:
// - place_at(path, t): the Place t metres along the path, with .height and .sun for the
//   next two functions
// - sun_transmittance(place): the fraction of air.sun that arrives there; 0 in the
//   planet's shadow
// - scattered_before(place): radiance that arrives from all sides equally, having been
//   scattered before
// - density_at(height): densities of molecules (x), dust (y) and the layer (z)
// - extinction(densities): the extinction per metre, one value per colour channel
// - phase_rayleigh(cos_angle), phase_dust(cos_angle, air.mie_g): use path.cos_angle,
//   the cosine of the angle between the path and the direction to the sun
//
// A metre of air scatters the fraction air.rayleigh * x of light at molecules and
// air.mie * y at dust; the layer only absorbs. Multiply the scattered sunlight of each kind
// by its phase function, which gives the part that continues along the path. Multiply
// scattered_before by the two fractions alone: it arrives from 4 pi steradians, and the
// phase function of light from all sides is 1 / (4 pi), so the two cancel.
//
// The light of a part is attenuated by all parts before it and by half of its own
// optical depth.
// [/in_scatter]
Along in_scatter(int samples, Path path) {
    return Along(vec3(0.0), vec3(1.0));
}
