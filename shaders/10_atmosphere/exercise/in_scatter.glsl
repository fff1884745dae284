// Exercise 10.in_scatter: what is scattered in on a path, and what gets through it.
// Until you fill it in, air is clear and dark.
#include "10_atmosphere/phase.glsl"
#include "10_atmosphere/sunlight.glsl"

// [in_scatter]
// The path in `samples` equal parts (1 or more), each of which is taken to be as in its middle:
//     place_at(path, t)         the Place t metres along the path: .height, and .sun as the next two want it
//     sun_transmittance(place)  what of air.sun gets there; 0 in the planet's shadow
//     scattered_before(place)   radiance that comes from all sides, having been scattered before
//     density_at(height)        of molecules (x), dust (y) and the layer (z); extinction(densities) per metre
//     phase_rayleigh(cos_angle), phase_dust(cos_angle, air.mie_g)   of the angle between path and sun, path.cos_angle
// A metre of air scatters air.rayleigh * density x and air.mie * density y of what comes by; the layer scatters nothing. Of
// the sun's light the phase function says what share goes along the path; of what comes from all sides, as much goes in each
// direction as comes from it. What a part sends goes through all parts before it and through half of its own.
// [/in_scatter]
Along in_scatter(int samples, Path path) {
    return Along(vec3(0.0), vec3(1.0));
}
