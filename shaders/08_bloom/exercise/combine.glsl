// Exercise 08.combine: adds the blurred light to the picture.
// Starter: the blurred light is lost.
#include "common/light.glsl"

// [combine]
// Returns the radiance of a pixel of the picture with its bloom.
// - `radiance` is the pixel before bloom; it may be infinite or NaN, so use
//   finite_light(radiance) instead. `spread`, the blurred light, is finite and 0 or
//   more.
// - If `mixes` is false, only bright light was blurred. Add strength * spread (strength
//   0 or more).
// - If `mixes` is true, all light of the picture was blurred, and adding it would make
//   the picture brighter. Light moves instead: the pixel loses the fraction `strength`
//   (0 to 1) of its own light, and receives strength * spread.
//
// The result is finite light as well: apply finite_light to it.
// [/combine]
vec3 combine(vec3 radiance, vec3 spread, float strength, bool mixes) {
    return radiance;
}
