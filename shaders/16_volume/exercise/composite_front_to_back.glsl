// Exercise 16.composite_front_to_back: samples along a ray, the nearest first; and when to stop.
// As it stands samples are added as if nothing lay before them, and no ray stops early.

// [composite_front_to_back]
// `so_far` holds the light of all samples before this one (rgb, linear radiance) and what of the light behind them still
// gets through (a: the transmittance, 1 at first). Returns the same with one more sample behind them, which shines with
// `radiance` as far as it is opaque: a sample of opacity 0.25 adds a quarter of its radiance, weakened by what lies before
// it, and lets three quarters through.
// [/composite_front_to_back]
vec4 composite_front_to_back(vec4 so_far, vec3 radiance, float opacity) {
    return vec4(so_far.rgb + opacity * radiance, so_far.a);
}

// [is_finished]
// True where nothing that may still come can change any channel of the picture by more than `threshold` (above 0):
// `transmittance` gets through, and nothing behind is brighter than `brightest`, which is linear radiance, 0 or more: the
// volume's own light or a lamp behind it, 50 perhaps. A limit on the transmittance alone does not know that.
// [/is_finished]
bool is_finished(float transmittance, float brightest, float threshold) {
    return false;
}
