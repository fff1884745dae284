// wrong: leaves a triangle
#include <algorithm>
#include <cmath>

#include "13_mlaa/exercises.h"

namespace lightwalk::exercise {

float area(int position, int length) { return std::max(0.0f, 0.5f * (1.0f - float(2 * position + 1) / float(length))); }

}  // namespace lightwalk::exercise
