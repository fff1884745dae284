// Exercise 03.range_fade: a light that fades to nothing at its range.
// Until you fill it in, it is equally bright up to its range and ends there.

// [range_fade]
// (1 - distance / range)^2 / (1 + k distance^2), and 0 at the range and beyond it. Distance and range are in metres, 0 or
// more; k is 0 or more. A light whose range is 0 lights nothing, not even at distance 0: the result is 0, not NaN.
// [/range_fade]
float range_fade(float distance, float range, float k) {
    return distance < range ? 1.0 : 0.0;
}
