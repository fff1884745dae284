// Exercise 11.march: along a ray by steps as long as they can be.
// Until you fill it in, nothing is ever hit.
#include "11_fractals/march_along.glsl"

// [march]
// Goes along a ray from t = `start` to `end`, metres. distance_at(t) says how far it is at least from there to the set, 0 in
// it; it is what costs time. Result: March(t, steps, ended), steps being how often you asked.
// - MARCH_HIT where the distance is at most epsilon + slope * t: t is that place.
// - MARCH_MISS where nothing can be hit before `end`: t is `end`.
// - MARCH_CAPPED after `most` distances (1 or more): t is where it has come to, which rays along an edge do.
// `relaxation` is 1 to 2. At 1 each step is as long as the distance. Above, it is relaxation times as long, and so it may
// leap over the set. It has not where the sphere around the point that it comes to, as large as the distance there, still
// touches the sphere around the point that it came from. Where the two do not touch: go back to where the step without
// relaxation would have led, and on from there. A place beyond a gap is no hit, and one beyond `end` is no proof of a miss.
// [/march]
March march(float start, float end, float epsilon, float slope, float relaxation, int most) {
    return March(end, 1, MARCH_MISS);
}
