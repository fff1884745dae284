// Exercise 12.mix_albedo: the albedo before and after the blur.
// Starter: all of it is applied after the blur.

// [mix_albedo]
// The albedo is the fraction of light that remains after entering and leaving the skin.
// A share s (0 to 1) of it is applied before the light is blurred, the rest after.
// albedo_before returns the albedo to the power s, albedo_after the albedo to the power
// 1 - s, channel by channel: without a blur their product is the albedo for every s.
//
// The components of the albedo are 0 to 1. pow(0, 0) is undefined in GLSL: for s = 0
// albedo_before is exactly 1, for s = 1 albedo_after is exactly 1. For any power above
// 0, an albedo of 0 gives 0.
// [/mix_albedo]
vec3 albedo_before(vec3 albedo, float s) { return vec3(1.0); }

vec3 albedo_after(vec3 albedo, float s) { return albedo; }
