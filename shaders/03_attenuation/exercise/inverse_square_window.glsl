// Exercise 03.inverse_square_window: the inverse square law, led to 0 at the light's range.
// Until you fill it in, a light is equally bright up to its range and ends there.

// [inverse_square_window]
// (1 - (distance / range)^4)^2 / (distance^2 + 1), and 0 at the range and beyond it. Distance and range are in metres, 0
// or more. A light whose range is 0 lights nothing, not even at distance 0: the result is 0, not NaN.
// [/inverse_square_window]
float inverse_square_window(float distance, float range) {
    return distance < range ? 1.0 : 0.0;
}
