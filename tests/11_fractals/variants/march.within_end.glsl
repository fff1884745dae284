// right, in its pictures too
#include "11_fractals/march_along.glsl"
March march(float start, float end, float epsilon, float slope, float relaxation, int most) {
    float t = start, last_t = start, last_d = 0.0, step = 0.0;
    for (int i = 1; i <= most; ++i) {
        float d = distance_at(t);
        if (last_d + d < step) {
            t = last_t + last_d;
            step = last_d;
            continue;
        }
        if (t <= end && d <= epsilon + slope * t) return March(t, i, MARCH_HIT);
        if (t + d >= end) return March(end, i, MARCH_MISS);
        last_t = t;
        last_d = d;
        step = min(relaxation * d, end - t);
        t += step;
    }
    return March(t, most, MARCH_CAPPED);
}
