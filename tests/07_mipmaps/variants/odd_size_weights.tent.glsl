// wrong: odd_size_weights(i = 0, size = 5)
vec3 odd_size_weights(int i, int size) {
    // The same weights everywhere: right for a size of 3, and the edges count too little for others.
    if (size == 1) return vec3(1.0, 0.0, 0.0);
    return size % 2 == 0 ? vec3(0.5, 0.5, 0.0) : vec3(1.0 / 3.0);
}
