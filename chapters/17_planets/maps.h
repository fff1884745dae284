// The images of bodies: maps, slopes made of them, tables of rings.
#pragma once
#include <array>
#include <glm/glm.hpp>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "10_atmosphere/air_data.h"
#include "17_planets/body_data.h"
#include "common/scene/image_pool.h"

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

/// End of the time, from J2000 on, for which place_body() and the lesson state accuracies: 1 January 2050.
constexpr double accurate_until_days = 18263;

/// At a moment in days since J2000 (1 January 2000, 12:00). Planets by E. M. Standish, "Keplerian elements for
/// approximate positions of the major planets", JPL, table 1: the elements of J2000 and the rate of the mean
/// longitude alone. The Moon by the largest term of each coordinate (J. Meeus, Astronomical Algorithms, 1991, chapter
/// 45). From 2000 to 2050 planets are up to a sixth of a degree off and the Moon 3.1 degrees; from 1900 to 2100 a third
/// of a degree and 3.9 degrees. Poles and rotations by B. A. Archinal et al., Celestial Mechanics and Dynamical
/// Astronomy 130, 2018, without their periodic terms (Mars: 109, 2011, without such terms).
Placement place_body(BodyId body, double days);

/// From equatorial coordinates of J2000, in degrees, to a unit vector of the world.
glm::dvec3 direction_of(double right_ascension_deg, double declination_deg);

/// From the world's axes to a star map's in galactic coordinates: its centre +z, its north pole +y.
glm::dmat3 world_to_galaxy();

/// How a body's pass is compiled.
enum class BodyKind { rock, clouded, earth, flowing, ringed, star };

struct BodyTraits {
    const char* map;    ///< file below assets/planets_2k/ or assets/; null: made here, or none
    double radius_m;    ///< at its equator
    double flattening;  ///< (equator - pole) / equator
    BodyKind kind;
    SurfaceLaw surface;
    int octaves;  ///< of the slopes that overlay_normals() finds in the map; 0: none
    float slope;  ///< of those
};

/// Radii: B. A. Archinal et al., Celestial Mechanics and Dynamical Astronomy 130, 2018. Laws: the lesson says which and why.
const BodyTraits& traits(BodyId body);

/// The air of a body, lit by `sunlight` (irradiance of a facing surface). Zero scale heights if it has no visible
/// air.
Air air_of(BodyId body, glm::vec3 sunlight, float sun_rad);

/// The rings' radii in metres; outer 0: none.
Rings rings_of(BodyId body);

/// One ring or a part of one: between two radii its optical depth, and the single-scattering albedo of its particles.
struct RingPart {
    double inner_m, outer_m, depth, albedo;
};
std::span<const RingPart> ring_parts(BodyId body);

struct BodyMaps {
    std::shared_ptr<Image> color, normals;
    std::shared_ptr<Image> night, water, clouds;  ///< of the Earth
    std::vector<std::shared_ptr<Image>> frames;   ///< of Jupiter, a day apart, `color` first; none unless asked for
    std::shared_ptr<Image> rings;  ///< four layers: ω and optical depth; the tables back, forward, unlit
};

/// Maps of a body, if it has them, and with `frames` Jupiter's later frames. Throws InputError if a file is missing or damaged.
BodyMaps load_maps(Gpu& gpu, ImagePool& pool, BodyId body, bool frames);

/// Days from Jupiter's map to the last of its kept frames, of which there is one a day.
constexpr int sequence_days = 4;

/// Interval of Jupiter's kept frames at a time. After the last frame the first follows again.
struct FrameInterval {
    size_t first, second;  ///< frames at its ends
    float days;            ///< from the first frame of all, below the length of the loop
    float period_days;     ///< 1, 2 or 4: what is nearest to the period asked for
};
FrameInterval frame_interval(double days, float period_days);

/// Colours of Pluto in sRGB, RGBA, row by row from the north: no free map of it was found, so these are its published
/// regions (S. A. Stern et al., Science 350, 2015): the bright western lobe of the heart and its paler eastern one,
/// the dark belt along the equator, the yellowish north, with noise for finer detail.
std::vector<uint8_t> pluto_map(int width, int height);

/// Of one ring: ω's colour and the optical depth, from the inner to the outer edge; and the three tables of 17.ring_phase, made by
/// single scattering at a sun and a camera `elevation_rad` above the rings.
std::vector<glm::vec4> ring_strip(BodyId body, int texels);
std::vector<glm::vec4> ring_table(const std::vector<glm::vec4>& strip, int table, double elevation_rad);

/// Light of single scattering, as shaders/17_planets/single_scattering.glsl has it.
namespace scattering {
double back(double depth, double mu0, double mu);
double through(double depth, double mu0, double mu);
double more(double depth, double albedo, bool lit);
double particle_phase(double cos_phase);
}  // namespace scattering

}  // namespace lightwalk
