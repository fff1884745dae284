// Car paint by random walks of light: what an instrument would measure.
#pragma once
#include <random>

#include "14_environment/measured_brdf.h"

namespace lightwalk {

/// Particles of pigment and flakes of metal, mixed below a smooth coat and infinitely deep. It shares no formula with
/// 14_environment/paint_model.glsl: light may meet any number of them, and the coat from below.
struct WalkedPaint {
    glm::dvec3 pigment{0.82, 0.05, 0.06};  ///< albedo of a particle, which scatters evenly in all directions
    glm::dvec3 flake{0.95, 0.35, 0.25};    ///< reflectance of a flake, a mirror on both sides
    double flakes = 0.4;                   ///< share of a vertical ray's collisions, 0 to 1
    double alpha = 0.2;                    ///< spread of the flakes' normals about the vertical, above 0
    double index = 1.5;                    ///< of refraction of the coat, 1 or more
};

/// BRDF per steradian, without the coat's own reflection: the mean of `walks` paths. Unit directions above the surface.
glm::dvec3 walked_brdf(const WalkedPaint& paint, const LightAndView& seen, int walks, uint32_t seed = 1);

/// A table of walked_brdf(); cells below the surface have no data.
MeasuredBrdf measure_by_walks(const WalkedPaint& paint, glm::ivec3 cells, int walks);

}  // namespace lightwalk
