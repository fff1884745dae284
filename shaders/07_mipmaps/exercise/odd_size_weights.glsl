// Exercise 07.odd_size_weights: how much of each texel lies under a texel of the next level.
// Until you fill it in, an odd size loses its last column, as by box_2x2.

// [odd_size_weights]
// A row of `size` texels becomes one of m = max(size / 2, 1). Stretched over the same length, texel i of the new row lies
// over the old texels 2 i, 2 i + 1 and 2 i + 2. Returns what share of it each covers, in this order; the shares add up
// to 1. An old texel that is not there, at `size` or beyond, has the weight 0. size is 1 or more, i from 0 to m - 1.
// [/odd_size_weights]
vec3 odd_size_weights(int i, int size) {
    return size == 1 ? vec3(1.0, 0.0, 0.0) : vec3(0.5, 0.5, 0.0);
}
