// Exercise 07.odd_size_weights: the share of each texel under a texel of the next level.
// Starter: an odd size loses its last column, as it does with box_2x2.

// [odd_size_weights]
// A row of `size` texels (1 or more) becomes a row of m = max(size / 2, 1) texels of
// the same total length, m rounded down. Texel i of the new row (0 to m - 1) then lies
// over the old texels 2 i, 2 i + 1 and 2 i + 2. Returns the fraction of the new texel
// that each of the three covers, in this order. The fractions add up to 1. An old texel
// that does not exist (index `size` or more) has the weight 0.
// [/odd_size_weights]
vec3 odd_size_weights(int i, int size) {
    return size == 1 ? vec3(1.0, 0.0, 0.0) : vec3(0.5, 0.5, 0.0);
}
