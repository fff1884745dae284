// right
vec3 odd_size_weights(int i, int size) {
    // By the definition: how much of [begin, end] lies in each of the three.
    float m = float(max(size / 2, 1)), begin = float(i) * float(size) / m, end = begin + float(size) / m;
    vec3 left = vec3(2 * i, 2 * i + 1, 2 * i + 2);
    vec3 covered = max(min(vec3(end), left + 1.0) - max(vec3(begin), left), 0.0) * m / float(size);
    // Rounding must not weigh a texel that is not there.
    if (size % 2 == 0 || size == 1) covered.z = 0.0;
    if (size == 1) covered = vec3(1.0, 0.0, 0.0);
    return covered / (covered.x + covered.y + covered.z);
}
