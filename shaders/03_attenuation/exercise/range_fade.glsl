// Exercise 03.range_fade: attenuation that fades a light to 0 at its range.
// Starter: a light is equally bright up to its range and ends there.

// [range_fade]
// The range fade: (1 - distance / range)^2 / (1 + k distance^2), and exactly 0 at the range
// and beyond it. Distance and range are in metres, 0 or more; k is in 1/m², 0 or more. A
// light of range 0 lights nothing, not even at distance 0: the result is 0, not NaN.
// [/range_fade]
float range_fade(float distance, float range, float k) {
    return distance < range ? 1.0 : 0.0;
}
