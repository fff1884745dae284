// Solution of 07.odd_size_weights.

// A new texel is size / m old ones wide, 2 + 1 / m where size is odd: it begins i / m into old texel 2 i.
vec3 odd_size_weights(int i, int size) {
    if (size == 1) return vec3(1.0, 0.0, 0.0);
    if (size % 2 == 0) return vec3(0.5, 0.5, 0.0);
    int m = size / 2;
    return vec3(m - i, m, i + 1) / float(size);
}
