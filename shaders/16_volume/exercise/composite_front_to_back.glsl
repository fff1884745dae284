// Exercise 16.composite_front_to_back: samples along a ray, the nearest first; and when to stop.
// Starter: samples are added as if nothing lay before them, and no ray stops early.

// [composite_front_to_back]
// `so_far` describes all samples in front of this one: their light (rgb, linear radiance)
// and the transmittance that is left behind them (a; 1 at first). Returns the same after
// one more sample. A sample of opacity 0.25 emits a quarter of its `radiance`, which is
// attenuated by the samples in front of it, and transmits three quarters of the light from
// behind.
// [/composite_front_to_back]
vec4 composite_front_to_back(vec4 so_far, vec3 radiance, float opacity) {
    return vec4(so_far.rgb + opacity * radiance, so_far.a);
}

// [is_finished]
// Returns true if nothing behind can change any channel of the picture by more than
// `threshold` (above 0), so that the ray may end here. `transmittance` is the fraction of
// the light from behind that still arrives. `brightest` (linear radiance, 0 or more) is a
// bound on that light: the volume's own, and that of a light source behind the volume,
// whose radiance may be 50.
// [/is_finished]
bool is_finished(float transmittance, float brightest, float threshold) {
    return false;
}
