// Irradiance of the sky on level ground.
#pragma once
#include <vector>

#include "10_atmosphere/air_data.h"
#include "common/base/epoch.h"

namespace lightwalk {

/// Irradiance of level ground at a height of 0 by light scattered once, in the unit of air.sun, for sun cosines x |x|
/// with x from -1 to 1 in equal steps. By eight times six directions of the upper half of the sky, each in 16
/// samples, sunlight by Smith and Smith's fit; in double precision, in some milliseconds.
class SkylightTable {
  public:
    /// True if the table is another one now. Sunlight and exposure only scale it; the air takes the milliseconds.
    bool follow(const Air& air);

    const std::vector<glm::vec3>& entries() const { return entries_; }
    int made = 0;  ///< for another air, so far

  private:
    Fingerprint scaled_;
    Fingerprint made_;
    std::vector<glm::dvec3> of_unit_sun_;
    std::vector<glm::vec3> entries_;
};

/// Between the table's entries: `sun` is the upward part of its direction, -1 to 1.
glm::vec3 skylight_of(const std::vector<glm::vec3>& table, float sun);

/// Sunlight on a facing surface at a height of 0, in the unit of air.sun; nothing once the sun's centre is below the
/// horizon. 512 samples of the path, in double precision.
glm::vec3 sunlight_of(const Air& air, float sun);

}  // namespace lightwalk
