// Exercise 03.inverse_square_window: inverse-square attenuation that reaches 0 at the light's range.
// Starter: a light is equally bright up to its range and ends there.

// [inverse_square_window]
// The windowed inverse square: (1 - (distance / range)^4)^2 / (distance^2 + 1), and exactly
// 0 at the range and beyond it. Both arguments are in metres, 0 or more. A light of range 0
// lights nothing, not even at distance 0: the result is 0, not NaN.
// [/inverse_square_window]
float inverse_square_window(float distance, float range) {
    return distance < range ? 1.0 : 0.0;
}
