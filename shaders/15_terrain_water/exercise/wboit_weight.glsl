// Exercise 15.wboit_weight: how much a transparent fragment counts in a sum that knows no order.
// Starter: every fragment counts the same, and what lies far behind shines through as if it were in front.

// [wboit_weight]
// The weight w of a fragment. `alpha`: 0 to 1. `distance_m`: along the view, above 0. `depth`:
// 0 at the near plane and 1 at the far plane, not reversed, and by rounding a little outside.
// `equation`: 0 to 4:
//
// 0: w = 1, a plain mean.
// 1 to 4: w = alpha * clamp(x, 0.01, 3000), with z the distance in metres and d the depth:
//   1 (equation 7 of the paper):  x = 10 / (1e-5 + (z/5)^2 + (z/200)^6)
//   2 (equation 8):               x = 10 / (1e-5 + (z/10)^3 + (z/200)^6)
//   3 (equation 9):               x = 0.03 / (1e-5 + (z/200)^4)
//   4 (equation 10):              x = 3000 (1 - d)^3
//
// Where d is above 1, 1 - d is negative, and GLSL's pow() is not defined there: multiply
// instead. Tolerance: 1e-3 of w. M. McGuire and L. Bavoil, "Weighted Blended Order-Independent
// Transparency", JCGT 2(2), 2013.
// [/wboit_weight]
float wboit_weight(int equation, float alpha, float distance_m, float depth) {
    return 1.0;
}
