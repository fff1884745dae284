// References of this chapter, in double precision.
#pragma once
#include <locale.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <glm/glm.hpp>
#include <string>
#include <string_view>

#include "01_obj/exercises.h"
#include "01_obj/lines.h"

namespace lightwalk::truth {

/// The float nearest to a decimal text: the C library's strtof, exact in glibc, always in the C locale.
inline float nearest_float(const std::string& text) {
    static const locale_t c_locale = newlocale(LC_ALL_MASK, "C", nullptr);
    return strtof_l(text.c_str(), nullptr, c_locale);
}

/// Floats between two floats, units in the last place: 0 where they are equal bit for bit, 1 where they are neighbours
/// or +0 and -0.
inline uint64_t ulps(float a, float b) {
    const auto order = [](float f) -> int64_t {
        const int64_t bits = std::bit_cast<uint32_t>(f);
        return bits & 0x80000000 ? -1 - (bits & 0x7fffffff) : bits;
    };
    return static_cast<uint64_t>(std::abs(order(a) - order(b)));
}

/// An OBJ file that is known to be well-formed, read as plainly as can be: floats by nearest_float, indices by strtol,
/// polygons by the version of triangulate in use. Without names.
inline ObjData parse(std::string_view text) {
    ObjData data;
    struct Face {
        std::vector<Corner> corners;
    };
    std::vector<Face> faces;
    Statements statements(without_mark(text));
    for (std::string_view rest; statements.next(rest);) {
        const std::string_view keyword = next_word(rest);
        const size_t wanted = keyword == "v" || keyword == "vn" ? 3 : keyword == "vt" ? 2 : 0;
        std::vector<float>& values = keyword == "v" ? data.positions : keyword == "vn" ? data.normals : data.uvs;
        for (size_t i = 0; i < wanted; ++i) {
            const std::string_view word = next_value(rest);
            values.push_back(word.empty() ? 0.0f : nearest_float(std::string(word)));
        }
        if (keyword != "f" && keyword != "fo") continue;
        Face& face = faces.emplace_back();
        for (std::string_view word; !(word = next_value(rest)).empty();) {
            uint32_t index[3] = {none, none, none};
            const int64_t so_far[3] = {static_cast<int64_t>(data.positions.size() / 3),
                                       static_cast<int64_t>(data.uvs.size() / 2),
                                       static_cast<int64_t>(data.normals.size() / 3)};
            for (int k = 0; k < 3 && !word.empty(); ++k) {
                const std::string number(word.substr(0, word.find('/')));
                word.remove_prefix(std::min(number.size() + 1, word.size()));
                if (number.empty()) continue;
                const int64_t i = std::strtoll(number.c_str(), nullptr, 10);
                index[k] = static_cast<uint32_t>(i > 0 ? i - 1 : so_far[k] + i);
            }
            face.corners.push_back({index[0], index[1], index[2]});
        }
    }
    for (const Face& face : faces) {
        std::vector<glm::vec3> polygon;
        for (const Corner& c : face.corners) {
            const float* p = data.positions.data() + 3 * size_t{c.position};
            polygon.emplace_back(p[0], p[1], p[2]);
        }
        if (polygon.size() == 3) {
            for (const Corner& c : face.corners) data.corners.push_back(c);
            continue;
        }
        for (const glm::uvec3& t : triangulate(polygon))
            for (int k = 0; k < 3; ++k) data.corners.push_back(face.corners[t[k]]);
    }
    return data;
}

/// Where a camera sees a point: x right and y down in -1 to 1, and the depth, in double precision and without a matrix.
inline glm::dvec3 project(const Camera& camera, double aspect, const glm::dvec3& point) {
    const glm::dvec3 forward = glm::normalize(glm::dvec3(camera.target) - glm::dvec3(camera.position));
    const glm::dvec3 right = glm::normalize(glm::cross(forward, glm::dvec3(camera.up)));
    const glm::dvec3 to_point = point - glm::dvec3(camera.position);
    const double distance = glm::dot(to_point, forward), half = std::tan(0.5 * double{camera.fov_y_rad});
    const double near_m = camera.near_m, far_m = camera.far_m;
    // 1/distance is linear on the screen; depth is its share of the way from 1/far to 1/near.
    const double depth = (1.0 / distance - 1.0 / far_m) / (1.0 / near_m - 1.0 / far_m);
    return {glm::dot(to_point, right) / (distance * half * aspect),
            -glm::dot(to_point, glm::cross(right, forward)) / (distance * half), depth};
}

}  // namespace lightwalk::truth
