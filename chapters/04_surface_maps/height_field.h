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
    /// `heights`: size.x * size.y values from 0 to 1, 1 at the mesh, rows from the top.
    HeightField(glm::ivec2 size, std::vector<float> heights) : size_(size), heights_(std::move(heights)) {}

    glm::ivec2 size() const { return size_; }

    /// Bilinear depth between texel centres.
    double depth(glm::dvec2 at) const;

    /// Depth t at which the ray through start + t * along hits the surface; exact_hit() of surface_maps.glsl.
    double exact(glm::dvec2 start, glm::dvec2 along) const;

    /// Depth by a method of the chapter, for a ray with this cosine to the normal (above 0). `start`: where flat and
    /// normal see the surface. offset and offset_limited return one sample's depth; use place().
    double hit(const std::string& method, int steps, glm::dvec2 start, glm::dvec2 along) const;

    /// Hit point of the method, in texels.
    glm::dvec2 place(const std::string& method, int steps, glm::dvec2 start, glm::dvec2 along, double cosine) const;

  private:
    double texel(glm::ivec2 at) const;
    glm::ivec2 size_{0};
    std::vector<float> heights_;
};

}  // namespace lightwalk
