// Where the Sun, its planets and the Moon are, and how they are turned, in double precision.
#pragma once
#include <array>
#include <glm/glm.hpp>
#include <string>
#include <vector>

namespace lightwalk {

/// In the order of their distance from the Sun, as the knob `at` names them.
enum class BodyId { sun, mercury, venus, earth, moon, mars, jupiter, saturn, uranus, neptune, pluto };
constexpr size_t body_count = 11;
const std::vector<std::string>& body_names();

constexpr double astronomical_unit_m = 1.495978707e11;
constexpr double sun_radius_m = 6.957e8;

/// A body's place and axes. World: metres from the Sun, +y towards the north pole of the Earth's orbit, +z towards the
/// vernal equinox of J2000.
struct Placement {
    glm::dvec3 position{0.0};
    glm::dmat3 axes{1.0};  ///< columns: the body's +x (90° east), +y (its north pole) and +z (its prime meridian)
    glm::dmat4 matrix() const;
};

/// At a moment in days since J2000 (1 January 2000, 12:00). Planets by E. M. Standish, "Keplerian elements for
/// approximate positions of the major planets", JPL, table 1: the elements of J2000 and the rate of the mean
/// longitude alone. Without the other rates a position is some arc minutes off in the decades around 2000, a quarter
/// of a degree in 1800. The Moon by the largest term of each coordinate (J. Meeus, Astronomical Algorithms, 1991,
/// chapter 45; a degree off), poles and rotations by B. A. Archinal et al., Celestial Mechanics and Dynamical
/// Astronomy 130, 2018, without their periodic terms (Mars: 109, 2011, without such terms).
Placement place_body(BodyId body, double days);

/// From equatorial coordinates of J2000, in degrees, to a unit vector of the world.
glm::dvec3 direction_of(double right_ascension_deg, double declination_deg);

/// From the world's axes to a star map's in galactic coordinates: its centre +z, its north pole +y.
glm::dmat3 world_to_galaxy();

}  // namespace lightwalk
