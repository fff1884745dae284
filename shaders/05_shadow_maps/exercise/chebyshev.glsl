// Exercise 05.chebyshev: visibility from the mean and the mean square of depth.
// Starter: everything behind the mean depth is in shadow.

// [chebyshev]
// An upper bound on the visibility of a point at `depth`. `moments` holds the mean of the
// depth and the mean of its square over all texels that were blurred together; depth grows
// with the distance from the light. If the point is not behind the mean, the result is 1.
// Otherwise the one-sided Chebyshev inequality limits the share of those texels at `depth`
// or farther to variance / (variance + (depth - mean)²); this is the result. A variance
// below `least` (above 0) is rounding noise and counts as `least`.
// [/chebyshev]
float chebyshev(vec2 moments, float depth, float least) {
    return depth <= moments.x ? 1.0 : 0.0;
}
