// Exercise 08.combine: the picture and the light that was spread.
// Until you fill it in, the light is lost.
#include "common/light.glsl"

// [combine]
// `spread` is finite and 0 or more. Of the radiance, which may be anything, finite_light(radiance) counts. Where `mixes` is
// false, `strength` (0 or more) times the spread light is added to it. Where it is true, `spread` is all of the picture's
// light, not what is bright alone: adding it would make the picture brighter, so strength (0 to 1 then) is the share of the
// light that is moved, and what is moved is taken away where it was. The result is finite light, too.
// [/combine]
vec3 combine(vec3 radiance, vec3 spread, float strength, bool mixes) {
    return radiance;
}
