// The C++ exercise of this chapter. Its name calls the exercise or the solution, according to the toggle.
#pragma once
#include <vector>

#include "common/base/exercise.h"

namespace lightwalk {

/// exercise/area.cpp says what it must do.
EXERCISE("13.area", float, area, int position, int length);

}  // namespace lightwalk
