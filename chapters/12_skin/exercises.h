// The C++ exercise of this chapter. The name calls the exercise or the solution, according to the toggle.
#pragma once
#include <vector>

#include "12_skin/sums.h"
#include "common/base/exercise.h"
#include "common/gpu/frame.h"

namespace lightwalk {

/// Inputs of 12.blur_irradiance.
struct BlurPasses {
    /// Compute: for each texel of its image `into` it sums up its texture `from` around it, along the block `blur`'s
    /// direction; the texture `stretch` says how many texels a millimetre is.
    const Pipeline& line;
    const Image& irradiance;                  ///< not blurred; to be read alone
    const Image& stretch;                     ///< to be read alone
    const Image& between;                     ///< result of the blur in one direction
    const std::vector<const Image*>& levels;  ///< one for each Gaussian, of the size of the others
    const std::vector<Gaussian>& sum;         ///< those Gaussians, narrow ones first
};

/// Specification: exercise/blur_irradiance.cpp.
EXERCISE("12.blur_irradiance", void, blur_irradiance, Frame& frame, const BlurPasses& passes);

}  // namespace lightwalk
