// C++ exercise of this chapter. The name calls the student's version or the reference, as the switch says.
#pragma once
#include "common/base/exercise.h"

namespace lightwalk {

/// Specification: exercise/cascade_split.cpp.
EXERCISE("05.cascade_split", float, cascade_split, float near_m, float far_m, int i, int count, float lambda);

}  // namespace lightwalk
