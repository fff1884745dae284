// The light that coloured glass lets through.

// [tint_through]
// Shares multiply, in each channel by itself: Beer and Lambert's law for one wavelength band.
vec3 tint_through(vec3 passed, float alpha, vec3 tint) {
    return passed * (1.0 - alpha) * tint;
}
// [/tint_through]
