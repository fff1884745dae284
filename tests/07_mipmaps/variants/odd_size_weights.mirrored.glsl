// wrong: odd_size_weights(
vec3 odd_size_weights(int i, int size) {
    if (size == 1) return vec3(1.0, 0.0, 0.0);
    if (size % 2 == 0) return vec3(0.5, 0.5, 0.0);
    int m = size / 2;
    return vec3(i + 1, m, m - i) / float(size);
}
