// The C++ exercise of this chapter. Its name calls the exercise or the solution, according to the toggle.
#pragma once
#include <vector>

#include "common/base/exercise.h"

namespace lightwalk {

/// Specification: exercise/area.cpp.
EXERCISE("13.area", float, area, int position, int length);

}  // namespace lightwalk
