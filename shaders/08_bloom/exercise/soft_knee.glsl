// Exercise 08.soft_knee: how much of a luminance is above a threshold that has no edge.
// Until you fill it in, everything is.

// [soft_knee]
// Let w be knee * threshold. Nothing of a luminance up to threshold - w passes: 0. From threshold + w on it is the luminance
// minus the threshold. In between a parabola, (luminance - threshold + w)^2 / (4 w), joins the two without a step and
// without a corner. Luminance and threshold are 0 or more, knee is 0 to 1. w may be 0: then there is no in between.
// [/soft_knee]
float soft_knee(float luminance, float threshold, float knee) {
    return luminance;
}
