// Errors of a picture against double precision: the depths of a Julia set, the normals of a terrain.
#pragma once
#include <map>
#include <nlohmann/json_fwd.hpp>

#include "11_fractals/julia.h"
#include "11_fractals/terrain.h"

namespace lightwalk {

class DepthError {
  public:
    /// Judges the whole picture just drawn by `julia`, by rays through a grid of its pixels marched in double
    /// precision. Adds to `error`
    ///     depth_error   the mean of |depth - true depth| in metres, at most 0.1 for each ray, and 0.1 where one of the
    ///                   two hits and the other does not
    ///     misjudged     the share of these rays
    ///     evaluations   the mean number of distances evaluated, over all pixels with a ray through the ball around
    ///                   the set
    ///     capped        the share of these pixels that were stopped early
    void measure(Gpu& gpu, const Julia& julia, const Camera& camera, double time_s, nlohmann::json& error);

  private:
    std::map<std::string, std::vector<double>> known_;  ///< true depths by their parameters
};

/// Of a whole picture that `terrain` has just drawn with show = normals into `frame`, for a grid of its pixels: adds to
/// `error` normal_deg, the mean angle in degrees between the normal that was drawn and that of the same octaves in
/// double precision. A half float's normal is known to 0.03 degrees.
void measure_normals(Gpu& gpu, const Terrain& terrain, const Frame& frame, nlohmann::json& error);

}  // namespace lightwalk
