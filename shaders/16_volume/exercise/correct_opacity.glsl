// Exercise 16.correct_opacity: the opacity of a step of another length.
// Starter: every step is as opaque as one of the reference length: shorter steps make a denser volume.

// [correct_opacity]
// `opacity` (0 to 1) is the fraction of the incoming light that a layer of the reference
// length absorbs. Returns the fraction that a layer of the same matter absorbs if it is
// `ratio` times as long (0 or more).
//
// Two layers of half the length, one behind the other, must transmit as much as the whole
// layer. Opaque matter (opacity 1) stays opaque at any length above 0. A layer of no length
// (ratio 0) absorbs nothing, even if the matter is opaque. GLSL leaves pow(0, 0) and log(0)
// undefined.
// [/correct_opacity]
float correct_opacity(float opacity, float ratio) {
    return opacity;
}
