// The C++ exercises of this chapter. Each name calls the student's version or the reference, as the toggle says.
#pragma once
#include <glm/glm.hpp>
#include <vector>

#include "common/base/exercise.h"
