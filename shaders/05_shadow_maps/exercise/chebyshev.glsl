// Exercise 05.chebyshev: shadow from the mean and the mean square of depths.
// Until you fill it in, whatever is behind the mean depth is in shadow.

// [chebyshev]
// Of a texel `moments` are the mean of depth and the mean of its square, over all that was blurred into it; depth grows
// with the distance from the light. At most how much of what is there is as far as `depth` or farther? That is taken for
// the visibility: Chebyshev's inequality for one side, variance / (variance + (depth - mean)²), and all of it for what is
// not behind the mean. A variance below `least` is noise and counts as `least` (above 0).
// [/chebyshev]
float chebyshev(vec2 moments, float depth, float least) {
    return depth <= moments.x ? 1.0 : 0.0;
}
