// wrong: march(
#include "11_fractals/march_along.glsl"

March march(float start, float end, float epsilon, float slope, float relaxation, int most) {
    float t = start, before = 0.0, step = 0.0;  // the distance at the point before, and how far t is from there
    for (int steps = 1; steps <= most; ++steps) {
        float distance = distance_at(t);
        if (before + distance < step) {  // between the two spheres there is a gap
            t += before - step;
            step = before;
            continue;
        }
        if (distance <= epsilon + slope * (t - start)) return March(t, steps, MARCH_HIT);
        if (t + distance >= end) return March(end, steps, MARCH_MISS);
        before = distance;
        step = min(relaxation * distance, end - t);
        t += step;
    }
    return March(t, most, MARCH_CAPPED);
}
