#include "14_environment/measured_brdf.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <glm/gtc/constants.hpp>

#include "common/base/error.h"
#include "common/base/files.h"

namespace lightwalk {
namespace {

static_assert(std::endian::native == std::endian::little);

constexpr glm::dvec3 per_stored(1.0 / 1500, 1.15 / 1500, 1.66 / 1500);
constexpr int most_cells = 256;  // along an axis: volumes of every Vulkan device

size_t cells_in(glm::ivec3 cells) { return size_t(cells.x) * size_t(cells.y) * size_t(cells.z); }

}  // namespace

LightAndView directions_of(glm::ivec3 cells, glm::ivec3 cell) {
    const glm::dvec3 middle = (glm::dvec3(cell) + 0.5) / glm::dvec3(cells);
    const double h = glm::half_pi<double>() * middle.x * middle.x, d = glm::half_pi<double>() * middle.y;
    const double p = glm::pi<double>() * middle.z;
    const glm::dvec3 half(std::sin(h), 0, std::cos(h));
    const glm::dvec3 difference(std::sin(d) * std::cos(p), std::sin(d) * std::sin(p), std::cos(d));
    const glm::dvec3 to_light(half.z * difference.x + half.x * difference.z, difference.y,
                              half.z * difference.z - half.x * difference.x);
    return {to_light, 2 * std::cos(d) * half - to_light};
}

bool is_measured_file(const std::filesystem::path& file) { return file.extension() == ".binary"; }

MeasuredBrdf parse_measured(std::string_view bytes, const std::string& where) {
    MeasuredBrdf brdf;
    if (bytes.size() < sizeof brdf.cells)
        throw InputError("{}: {} bytes: expected three integers of 4 bytes, then numbers of 8", where, bytes.size());
    std::memcpy(&brdf.cells, bytes.data(), sizeof brdf.cells);
    bytes.remove_prefix(sizeof brdf.cells);
    for (int axis = 0; axis < 3; ++axis)
        if (brdf.cells[axis] < 1 || brdf.cells[axis] > most_cells)
            throw InputError("{}: {} x {} x {} cells: expected 1 to {} along each axis, such as 90 x 90 x 180", where,
                             brdf.cells.x, brdf.cells.y, brdf.cells.z, most_cells);
    const size_t cells = cells_in(brdf.cells);
    if (bytes.size() != cells * 3 * sizeof(double))
        throw InputError("{}: {} bytes behind the dimensions: {} x {} x {} cells of three doubles need {}", where,
                         bytes.size(), brdf.cells.x, brdf.cells.y, brdf.cells.z, cells * 3 * sizeof(double));
    brdf.values.resize(cells);
    bool any = false;
    for (size_t i = 0; i < 3 * cells; ++i) {
        double stored = 0;
        std::memcpy(&stored, bytes.data() + i * sizeof stored, sizeof stored);
        if (!std::isfinite(stored))
            throw InputError("{}: number {} of {} is {}: expected finite numbers; a negative one means no data", where,
                             i + 1, 3 * cells, stored);
        any = any || stored >= 0;
        const auto channel = static_cast<int>(i / cells);
        brdf.values[i % cells][channel] = stored * per_stored[channel];
    }
    if (!any) throw InputError("{}: all numbers are negative, which means no data: nothing was measured", where);
    return brdf;
}

MeasuredBrdf read_measured(const std::filesystem::path& file) { return parse_measured(read_file(file), file.string()); }

std::string measured_bytes(const MeasuredBrdf& brdf) {
    std::string bytes(reinterpret_cast<const char*>(&brdf.cells), sizeof brdf.cells);
    for (int channel = 0; channel < 3; ++channel)
        for (const glm::dvec3& value : brdf.values) {
            const double stored = value[channel] / per_stored[channel];
            bytes.append(reinterpret_cast<const char*>(&stored), sizeof stored);
        }
    return bytes;
}

}  // namespace lightwalk
