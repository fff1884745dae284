// right, in its pictures too
#include "11_fractals/march_along.glsl"

March march(float start, float end, float epsilon, float slope, float relaxation, int most) {
    float t = start, safe = start;  // up to `safe` there is nothing
    int steps = 0;
    while (steps < most) {
        float distance = distance_at(t);
        ++steps;
        if (t - distance > safe) {
            t = safe;
        } else if (distance <= epsilon + slope * t) {
            return March(t, steps, MARCH_HIT);
        } else {
            safe = t + distance;
            if (safe >= end) return March(end, steps, MARCH_MISS);
            t = min(t + relaxation * distance, end);
        }
    }
    return March(t, steps, MARCH_CAPPED);
}
