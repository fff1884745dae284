// wrong: area(0, 1)
#include <algorithm>
#include <cmath>

#include "13_mlaa/exercises.h"

namespace lightwalk::exercise {

float area(int position, int length) {
    const double m = 0.5 * length, a = std::min(double(position), m), b = std::min(position + 1.0, m);
    return float(0.5 * (b - a) * (1 - (a + b) / length));
}

}  // namespace lightwalk::exercise
