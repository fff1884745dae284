// Measured isotropic BRDFs and the file format of W. Matusik, H. Pfister, M. Brand and L. McMillan, "A Data-Driven
// Reflectance Model", SIGGRAPH 2003.
#pragma once
#include <filesystem>
#include <glm/glm.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace lightwalk {

/// BRDF per steradian over the angles of half vector and difference vector (S. Rusinkiewicz, "A New Change of Variables
/// for Efficient BRDF Representation", 1998): θh, 0 to 90° in steps of its square root, θd, 0 to 90°, and φd, 0 to 180°.
struct MeasuredBrdf {
    glm::ivec3 cells{0};             ///< along θh, θd and φd; 90, 90 and 180 in published files
    std::vector<glm::dvec3> values;  ///< RGB at the middles of cells, φd varies fastest; negative: no data
    glm::dvec3& at(glm::ivec3 cell) {
        return values[(size_t(cell.x) * size_t(cells.y) + size_t(cell.y)) * size_t(cells.z) + size_t(cell.z)];
    }
    const glm::dvec3& at(glm::ivec3 cell) const { return const_cast<MeasuredBrdf&>(*this).at(cell); }
};

/// Calls visit(cell) for each cell, in the order of the values.
template <class Visit>
void each_cell(glm::ivec3 cells, const Visit& visit) {
    for (glm::ivec3 c(0); c.x < cells.x; ++c.x)
        for (c.y = 0; c.y < cells.y; ++c.y)
            for (c.z = 0; c.z < cells.z; ++c.z) visit(c);
}

/// Unit directions to light and camera; the normal is +z.
struct LightAndView {
    glm::dvec3 to_light, to_eye;
    bool above() const { return to_light.z > 0 && to_eye.z > 0; }
};

/// Directions of a cell's middle. Some cells lie below the surface.
LightAndView directions_of(glm::ivec3 cells, glm::ivec3 cell);

bool is_measured_file(const std::filesystem::path& file);  ///< by its name: .binary

/// Throws InputError, which begins with `where`: dimensions outside 1 to 256, too few or too many bytes, a number that
/// is not finite, no data at all.
MeasuredBrdf parse_measured(std::string_view bytes, const std::string& where);
MeasuredBrdf read_measured(const std::filesystem::path& file);

std::string measured_bytes(const MeasuredBrdf& brdf);

}  // namespace lightwalk
