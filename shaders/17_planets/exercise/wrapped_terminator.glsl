// Exercise 17.wrapped_terminator: light that reaches around a planet's edge.
// Starter: the sun sets everywhere at n·l = 0.

// [wrapped_terminator]
// A cloud deck has no hard terminator: light enters it beside the point where it leaves.
// `cosine` is n·l, -1 to 1, of the round surface. Returns ((n·l + w) / (1 + w))^k: 1 where the
// sun is overhead, 0 where n·l is -w or less. `w` is 0 to 1, `k` above 0. pow() of a negative
// base is not defined: where n·l is below -w, return 0 without calling it.
// [/wrapped_terminator]
float wrapped_terminator(float cosine, float w, float k) {
    return max(cosine, 0.0);
}
