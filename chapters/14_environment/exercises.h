// The C++ exercises of this chapter. Each name calls the student's version or the reference, as the toggle says.
#pragma once
#include <glm/glm.hpp>
#include <vector>

#include "common/base/exercise.h"
#include "common/gpu/frame.h"

namespace lightwalk {

/// The nine coefficients of an environment in real spherical harmonics up to degree 2: a colour each, in the order
/// (0,0), (1,-1), (1,0), (1,1), (2,-2), (2,-1), (2,0), (2,1), (2,2). Degree 1 is along y, z and x.
using Sh9 = std::vector<glm::dvec3>;

/// Specification: exercise/sh_project.cpp. `texels`: row by row, from the upper edge.
EXERCISE("14.sh_project", Sh9, sh_project, int width, int height, const std::vector<glm::vec3>& texels);

/// Inputs of 14.prefilter_faces.
struct PrefilterPasses {
    const Pipeline& filter;    ///< compute, groups of 8x8 threads: a thread for each texel of its image `face_level`
    const Image& radiance;     ///< a cube with all its levels
    const Image& prefiltered;  ///< a cube of the same size, and all its levels that are used
    std::vector<With> with;    ///< modules that the shader uses
};

/// Of filter's uniform block `face_now`.
struct FaceNow {
    uint32_t face;    ///< 0 to 5
    float roughness;  ///< 0 to 1
};

/// Specification: exercise/prefilter_faces.cpp.
EXERCISE("14.prefilter_faces", void, prefilter_faces, Frame& frame, const PrefilterPasses& passes);

/// Specification: exercise/spectrum_bands.cpp.
EXERCISE("14.spectrum_bands", glm::vec3, spectrum_bands, const std::vector<float>& samples, float rate_hz);

}  // namespace lightwalk
