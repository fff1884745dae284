// Exercise 05.hidden_share: the share of the sun's disc that a planet hides.
// Starter: it hides nothing, and the planet casts no shadow.

// [hidden_share]
// The share of the sun's disc that a planet's disc hides, 0 to 1. All lengths are in radii
// of the sun, whose disc has radius 1. `radius`, 0 to 1e6, is the radius of the planet's
// disc. `gap` is the signed distance from the sun's centre to the nearest point of the
// planet's edge: 1 where the discs just touch, 0 where the edge passes through the sun's
// centre, negative where the edge lies beyond it, and never below -radius. A planet that
// looks smaller than the sun hides at most its own area.
// The overlap of two discs consists of two circular segments, one on either side of the
// chord through the points where the edges cross. If the planet looks hundreds of times as
// large as the sun, the rounding error of its segment's area exceeds the part of it that
// lies in front of the sun: there the planet's edge is straight, or nearly. An error of
// 0.002 is accepted.
// [/hidden_share]
float hidden_share(float radius, float gap) {
    return 0.0;
}
