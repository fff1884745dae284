// Exercise 11.march: sphere tracing along a ray, with steps as long as possible.
// Starter: nothing is ever hit.
#include "11_fractals/march_along.glsl"

// [march]
// Marches along a ray from t = `start` to t = `end`, in metres. distance_at(t) returns
// a lower bound of the distance to the set, 0 inside it; it is the expensive part.
// Returns March(t, steps, ended), where steps counts the calls of distance_at.
// - MARCH_HIT: the distance is at most epsilon + slope * t. t is that point.
// - MARCH_MISS: nothing can be hit before `end`. t is `end`.
// - MARCH_CAPPED: `most` distances (1 or more) were used, as happens to rays along an
//   edge. t is the point reached.
//
// `relaxation` is 1 to 2. A step is relaxation times as long as the distance. With a
// relaxation of 1 it is safe; with more it may skip the set. It has skipped nothing if
// the sphere around the new point, with the distance there as its radius, overlaps or
// touches the sphere around the old point. If there is a gap between the two, go back
// to where the step without relaxation would have led, and continue from there; later steps
// are relaxed again.
//
// A point beyond a gap is not a hit, however small its distance. A point beyond `end`
// proves a miss only if the step to it is known to have skipped nothing.
// [/march]
March march(float start, float end, float epsilon, float slope, float relaxation, int most) {
    return March(end, 1, MARCH_MISS);
}
