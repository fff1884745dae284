// Error of the terrain's normals against double precision.
#pragma once
#include <nlohmann/json_fwd.hpp>

#include "11_fractals/terrain.h"

namespace lightwalk {

/// Of a whole picture that `terrain` has just drawn with show = normals into `frame`, for a grid of its pixels: adds to
/// `error` normal_deg, the mean angle in degrees between the normal that was drawn and that of the same octaves in
/// double precision. A half float's normal is known to 0.03 degrees.
void measure_normals(Gpu& gpu, const Terrain& terrain, const Frame& frame, nlohmann::json& error);

}  // namespace lightwalk
