// wrong: expected 1
float chebyshev(vec2 moments, float depth, float least) {
    float d = depth - moments.x, v = max(least, moments.y - moments.x * moments.x);
    return v / (v + d * d);
}
