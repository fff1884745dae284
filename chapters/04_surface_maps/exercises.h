// C++ exercise of this chapter. The name calls the student's version or the reference, as the switch says.
#pragma once
#include "common/base/exercise.h"
#include "common/structs.h"

namespace lightwalk {

/// Specification: exercise/tangent_frame.cpp.
EXERCISE("04.tangent_frame", TangentFrame, tangent_frame, const Vertex& a, const Vertex& b, const Vertex& c);

}  // namespace lightwalk
