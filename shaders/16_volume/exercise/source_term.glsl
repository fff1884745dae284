// Exercise 16.source_term: the light that a point of a cloud sends to the camera.
// Starter: all matter emits, and nothing is scattered: a cloud is a black hole in the sky.
#include "16_volume/phase.glsl"

// [source_term]
// A ray runs from the camera along the unit vector `along`. Returns the source term of a
// point on it: the radiance that opaque matter there would send back to the camera, by
// emission and by scattering light once.
//
// - `albedo`, 0 to 1: the share of the light that is scattered there. The rest is absorbed.
// - `emitted`: the radiance that the matter would send if it scattered nothing. Only the
//   share that absorbs emits.
// - `sky`: the radiance that arrives from each direction of the sphere.
// - `irradiance`: of a light in the direction of the unit vector `to_light`, outside of the
//   volume. The optical depth of the path from there to the point is `depth`.
// - `g`: the mean cosine. phase(cosine, g) is the share that is scattered into a direction,
//   per steradian; its integral over all directions is 1. `cosine` is that of the angle by
//   which the light is turned: 1 if it goes on as before, -1 if it goes back.
// [/source_term]
vec3 source_term(vec3 albedo, vec3 emitted, vec3 sky, vec3 irradiance, vec3 to_light, vec3 along, float g, float depth) {
    return emitted;
}
