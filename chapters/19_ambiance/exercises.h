// The C++ exercises of this chapter. Each name calls the student's version or the reference, as the toggle says.
#pragma once
#include <array>
#include <glm/glm.hpp>
#include <vector>

#include "common/base/exercise.h"

namespace lightwalk {

/// Four neighbouring keys of a curve, and the knots (parameters) at which it passes them.
struct FourKeys {
    std::array<glm::dvec3, 4> points;
    std::array<double, 4> knots;  ///< rising; where two are equal, so are their points
};

/// Specification: exercise/catmull_rom.cpp.
EXERCISE("19.catmull_rom", glm::dvec3, catmull_rom, const FourKeys& keys, double t);

/// Specification: exercise/centripetal_knots.cpp.
EXERCISE("19.centripetal_knots", std::vector<double>, centripetal_knots, const std::vector<glm::dvec3>& points);

/// Specification: exercise/knot_at.cpp.
EXERCISE("19.knot_at", double, knot_at, const std::vector<double>& times_s, const std::vector<double>& knots,
         double time_s);

/// Specification: exercise/arc_length.cpp.
EXERCISE("19.arc_length", double, arc_length, const std::vector<glm::dvec3>& points, double share);

/// Specification: exercise/up_without_roll.cpp.
EXERCISE("19.up_without_roll", glm::dvec3, up_without_roll, glm::dvec3 up, glm::dvec3 from, glm::dvec3 to);

/// When a scene of a film is on the screen: from <= time < to, in seconds.
struct OnScreen {
    double from_s, to_s;
};

/// Specification: exercise/warm.cpp.
EXERCISE("19.warm", std::vector<int>, warm, const std::vector<OnScreen>& scenes, double now_s, double ahead_s,
         int most);

}  // namespace lightwalk
