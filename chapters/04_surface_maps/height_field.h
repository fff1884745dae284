// Height map surface on the CPU, in double precision, with the hit points of each method. Lengths along the surface are
// in texels, with texel centres at integers; the map repeats. Depth 0 is the mesh, 1 the deepest point.
#pragma once
#include <cmath>
#include <glm/glm.hpp>
#include <string>
#include <vector>

namespace lightwalk {

class HeightField {
  public:
    HeightField() = default;
    /// `heights` from 0 to 1, 1 at the mesh; size.x * size.y of them, rows from the top.
    HeightField(glm::ivec2 size, std::vector<float> heights) : size_(size), heights_(std::move(heights)) {}

    glm::ivec2 size() const { return size_; }

    /// Bilinear between texel middles.
    double depth(glm::dvec2 at) const;

    /// The depth at which a ray meets the surface that is above start + t * along at depth t: surface_maps.glsl's exact_hit().
    double exact(glm::dvec2 start, glm::dvec2 along) const;

    /// The same as a method of the chapter sees it, for a ray with this cosine to the normal (above 0). `start` is also
    /// where flat and normal see the surface. For offset and offset_limited the depth is that of one look; use place().
    double hit(const std::string& method, int steps, glm::dvec2 start, glm::dvec2 along) const;

    /// Where the method sees the surface, in texels.
    glm::dvec2 place(const std::string& method, int steps, glm::dvec2 start, glm::dvec2 along, double cosine) const;

  private:
    double texel(glm::ivec2 at) const;
    glm::ivec2 size_{0};
    std::vector<float> heights_;
};

}  // namespace lightwalk
