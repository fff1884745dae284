// Properties of the bodies of the solar system.
#pragma once
#include <span>

#include "10_atmosphere/air_data.h"
#include "17_planets/body_data.h"
#include "17_planets/orbits.h"

namespace lightwalk {

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

}  // namespace lightwalk
