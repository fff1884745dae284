// wrong: chebyshev
float chebyshev(vec2 moments, float depth, float least) {
    if (depth <= moments.x) return 1.0;
    float d = depth - moments.x, v = moments.y - moments.x * moments.x;
    return v / (v + d * d);
}
