// Exercise 19.knot_at: a camera that passes its keys at their times without a jump of its speed.
// Starter: the parameter rises evenly between two keys, and the speed jumps at each.
#include "19_ambiance/exercises.h"

namespace lightwalk::exercise {

// [knot_at]
// `times_s` are the times of a camera's keys, rising, and `knots` the parameters of its curve at
// them: as many, at least two, each at least as large as the one before. Returns the parameter
// at `time_s`, which rises so that its slope does not jump at a key.
//
// Until the first key it is that key's knot, and from the last key on that one's. Between two
// keys it is the cubic polynomial in time that has the two knots, and at the two keys these
// slopes: let the difference of a pair's knots over the time h between them be their mean slope
// d. At the first and at the last key the slope is d of the only pair there. At any other key,
// with d0 and h0 of the pair that ends there and d1 and h1 of the pair that begins, it is the
// least of 2 d0, 2 d1 and (d0 h1 + d1 h0) / (h0 + h1), which is the slope of the parabola
// through three keys. The parameter then never falls. Right within 1e-9 of the last knot.
// [/knot_at]
double knot_at(const std::vector<double>& times_s, const std::vector<double>& knots, double time_s) {
    if (!(time_s > times_s.front())) return knots.front();
    if (time_s >= times_s.back()) return knots.back();
    size_t i = 0;
    while (time_s >= times_s[i + 1]) ++i;
    return glm::mix(knots[i], knots[i + 1], (time_s - times_s[i]) / (times_s[i + 1] - times_s[i]));
}

}  // namespace lightwalk::exercise
