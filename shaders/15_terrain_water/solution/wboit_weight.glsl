// The weight of a transparent fragment in a sum that knows no order.

// [wboit_weight]
// Equations 7 to 10 of M. McGuire and L. Bavoil, "Weighted Blended Order-Independent Transparency", JCGT 2(2), 2013.
float wboit_weight(int equation, float alpha, float distance_m, float depth) {
    if (equation == 0) return 1.0;
    float by_5 = distance_m / 5.0, by_10 = distance_m / 10.0, by_200 = distance_m / 200.0, nearness = 1.0 - depth;
    float square = by_200 * by_200, x = 3000.0 * nearness * nearness * nearness;
    if (equation == 1) x = 10.0 / (1e-5 + by_5 * by_5 + square * square * square);
    if (equation == 2) x = 10.0 / (1e-5 + by_10 * by_10 * by_10 + square * square * square);
    if (equation == 3) x = 0.03 / (1e-5 + square * square);
    return alpha * clamp(x, 0.01, 3000.0);
}
// [/wboit_weight]
