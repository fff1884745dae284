// Exercise 16.correct_opacity: the opacity of a step of another length.
// As it stands every step is as opaque as one of the reference length: shorter steps make a denser volume.

// [correct_opacity]
// `opacity` (0 to 1) is what a layer of the reference length absorbs of the light that enters it. Returns what a layer of
// the same matter absorbs that is `ratio` (0 or more) times as long. Two layers of 1/2 the length in a row let through what
// the whole one does. What is wholly opaque (1) stays so at any length above 0; no length (ratio 0) absorbs nothing, even
// then. pow(0, 0) and log(0) are not defined.
// [/correct_opacity]
float correct_opacity(float opacity, float ratio) {
    return opacity;
}
