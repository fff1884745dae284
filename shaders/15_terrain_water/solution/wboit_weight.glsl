// The weight of a transparent fragment in a sum that knows no order.

// [wboit_weight]
// Equations 7 to 10 of M. McGuire and L. Bavoil, "Weighted Blended Order-Independent Transparency", JCGT 2(2), 2013.
float wboit_weight(int equation, float alpha, float distance_m, float depth) {
    float near_ones = distance_m / 200.0, x = 1.0;
    near_ones *= near_ones;
    float by_5 = distance_m / 5.0, by_10 = distance_m / 10.0, left = 1.0 - depth;
    if (equation == 1) x = 10.0 / (1e-5 + by_5 * by_5 + near_ones * near_ones * near_ones);
    if (equation == 2) x = 10.0 / (1e-5 + by_10 * by_10 * by_10 + near_ones * near_ones * near_ones);
    if (equation == 3) x = 0.03 / (1e-5 + near_ones * near_ones);
    if (equation == 4) x = 3000.0 * left * left * left;
    return equation == 0 ? 1.0 : alpha * clamp(x, 0.01, 3000.0);
}
// [/wboit_weight]
