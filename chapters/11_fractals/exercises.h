// The C++ exercise of this chapter. The name calls the exercise or the solution, according to the toggle.
#pragma once
#include <vector>

#include "common/base/exercise.h"
#include "common/gpu/frame.h"

namespace lightwalk {

/// Pipelines and images of exercise 11.record_cones.
struct ConePasses {
    const Pipeline& cone;    ///< compute: a cone for each texel of its image `starts`, which it writes
    const Pipeline& march;   ///< compute: a ray for each texel of its image `found`, from its texture `starts`
    const Image& starts;     ///< a texel for each tile of 8x8 pixels
    const Image& found;      ///< a texel for each pixel
    std::vector<With> with;  ///< modules of both shaders, for the pass's .with
};

/// Specification: exercise/record_cones.cpp.
EXERCISE("11.record_cones", void, record_cones, Frame& frame, const ConePasses& passes);

}  // namespace lightwalk
