// Exercise 12.mix_albedo: does skin's colour lie above the blur, below it, or both?
// Until you fill it in, all of it is multiplied after the blur.

// [mix_albedo]
// The texture's colour is what light has lost on its way in and on its way out. A share s (0 to 1) of it is multiplied to
// the light before it is blurred, the rest after: albedo to the power s, and to the power 1 - s, so that without a blur
// their product is the albedo for every s. Components of albedo are 0 to 1, and GLSL leaves pow(0, 0) open: s = 0 gives
// just 1 before, s = 1 just 1 after, and 0 in the texture stays 0 where the power is above 0.
// [/mix_albedo]
vec3 albedo_before(vec3 albedo, float s) { return vec3(1.0); }

vec3 albedo_after(vec3 albedo, float s) { return albedo; }
