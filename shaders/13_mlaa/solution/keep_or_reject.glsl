// Solution of 13.keep_or_reject.
bool keep_history(vec2 at, vec2 size, float expected, float farthest) {
    bool inside = all(greaterThanEqual(at, vec2(0.0))) && all(lessThan(at, size));
    return inside && farthest <= 1.05 * expected + 1e-6;
}
