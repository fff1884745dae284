// The layered model of 14_environment/paint_model.glsl, fitted to a measured BRDF.
#pragma once
#include "14_environment/measured_brdf.h"

namespace lightwalk {

/// As PaintFitBlock of 14_environment/paint_model.glsl.
struct PaintFit {
    glm::vec3 color{0}, edge_color{0}, flake_color{0};
    float flakes = 0.5f, flake_roughness = 0.45f;
};

/// Least squares over directions, weighted by both cosines: the colours in closed form for each of 37 roughnesses.
PaintFit fit_paint(const MeasuredBrdf& brdf);

}  // namespace lightwalk
