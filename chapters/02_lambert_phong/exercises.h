// C++ exercise of this chapter. The name calls the student's version or the reference, as the switch says.
#pragma once
#include <functional>

#include "common/base/exercise.h"
#include "common/gpu/frame.h"

namespace lightwalk {

/// Pipelines and callback for exercise 02.record_mist.
struct MistPasses {
    const Pipeline& sky;   ///< compute: writes every texel of its image `result`
    const Pipeline& mist;  ///< compute: reads and writes every texel of its image `result`, reads its texture `depth`
    std::function<void(Raster&)> draw_scene;  ///< with depth test and write; covers a part of the picture
};

/// Specification: exercise/record_mist.cpp.
EXERCISE("02.record_mist", void, record_mist, Frame& frame, const MistPasses& passes);

}  // namespace lightwalk
