// Exercise 08.soft_knee: the part of a luminance above a threshold without an edge.
// Starter: the whole luminance passes.

// [soft_knee]
// Returns the part of `luminance` that passes the threshold. Let w = knee * threshold.
// - Up to threshold - w, nothing passes: 0.
// - From threshold + w on, luminance - threshold passes.
// - In between, (luminance - threshold + w)^2 / (4 w) passes: a parabola that joins the
//   two parts without a step or a corner.
//
// Luminance and threshold are 0 or more, knee is 0 to 1. If w is 0 there is no range in
// between, and the parabola must not be evaluated.
// [/soft_knee]
float soft_knee(float luminance, float threshold, float knee) {
    return luminance;
}
