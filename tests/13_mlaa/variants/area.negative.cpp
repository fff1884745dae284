// wrong: behind the middle
#include <algorithm>
#include <cmath>

#include "13_mlaa/exercises.h"

namespace lightwalk::exercise {

float area(int position, int length) {
    if (length == 1) return 0.0f;
    if (2 * position + 1 == length) return 0.125f / float(length);
    return 0.5f * (1.0f - float(2 * position + 1) / float(length));
}

}  // namespace lightwalk::exercise
