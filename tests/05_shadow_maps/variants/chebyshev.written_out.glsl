// right
float chebyshev(vec2 moments, float depth, float least) {
    float d = max(depth - moments.x, 0.0), v = max(least, moments.y - moments.x * moments.x);
    return v / (v + d * d);
}
