#include <cmath>
#include <limits>

#include "checks.h"

namespace lightwalk {
namespace {

using Polygon = std::vector<glm::vec3>;

glm::dvec3 area_vector(const Polygon& polygon) {
    glm::dvec3 sum(0.0);
    for (size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec3 a = polygon[i] - polygon[0], b = polygon[(i + 1) % polygon.size()] - polygon[0];
        sum += 0.5 * glm::cross(a, b);
    }
    return sum;
}

// What a triangulation of any polygon has: n - 2 triangles of corners that exist.
bool has_form(const std::vector<glm::uvec3>& got, const Polygon& polygon, const std::string& what, Failures& failures) {
    if (got.size() != polygon.size() - 2) {
        failures.push_back("triangulate(" + what + ") gave " + std::to_string(got.size()) + " triangles, expected " +
                           std::to_string(polygon.size() - 2));
        return false;
    }
    for (const glm::uvec3& t : got)
        for (int k = 0; k < 3; ++k)
            if (t[k] >= polygon.size()) {
                failures.push_back("triangulate(" + what + ") gave corner " + std::to_string(t[k]) + ", there are " +
                                   std::to_string(polygon.size()));
                return false;
            }
    return true;
}

}  // namespace

Failures check_triangulate(std::vector<glm::uvec3> (*attempt)(std::span<const glm::vec3>)) {
    Failures failures;
    // A simple polygon: every triangle is wound as the polygon, and their areas add up to its own. Both together mean
    // that nothing is covered twice and nothing is left out.
    const auto covers = [&](const std::string& what, const Polygon& polygon) {
        const std::vector<glm::uvec3> got = attempt(polygon);
        if (!has_form(got, polygon, what, failures)) return;
        const glm::dvec3 whole = area_vector(polygon);
        double sum = 0.0;
        for (const glm::uvec3& t : got) {
            const double area =
                glm::dot(area_vector({polygon[t.x], polygon[t.y], polygon[t.z]}), whole) / glm::length(whole);
            if (area < -1e-6 * glm::length(whole)) {
                failures.push_back("triangulate(" + what + ") gave the triangle (" + std::to_string(t.x) + ", " +
                                   std::to_string(t.y) + ", " + std::to_string(t.z) +
                                   ") wound the other way than the polygon, or outside of it");
                return;
            }
            sum += area;
        }
        if (std::abs(sum / glm::length(whole) - 1.0) > 1e-4)
            failures.push_back("triangulate(" + what + ") covers " + std::to_string(100.0 * sum / glm::length(whole)) +
                               " % of the polygon's area, expected 100 %");
    };
    const auto returns = [&](const std::string& what, const Polygon& polygon) {
        has_form(attempt(polygon), polygon, what, failures);
    };

    covers("a triangle", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
    covers("a square", {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
    covers("a clockwise square", {{0, 1, 0}, {1, 1, 0}, {1, 0, 0}, {0, 0, 0}});
    Polygon circle, star, comb, far_star, tiny_star;
    for (int i = 0; i < 100; ++i) {
        const float angle = 6.2831853f * static_cast<float>(i) / 100.0f, radius = i % 2 ? 0.2f : 1.0f;
        circle.push_back({std::cos(angle), 0.0f, -std::sin(angle)});
        star.push_back({radius * std::cos(angle), radius * std::sin(angle), 0.3f * radius * std::cos(angle)});
        far_star.push_back(star.back() * 64.0f + glm::vec3(5000.0f, -3000.0f, 2000.0f));
        tiny_star.push_back(star.back() * 1e-12f);
    }
    covers("a circle of 100 corners", circle);
    covers("a star of 100 corners", star);
    covers("a star far from the origin", far_star);
    covers("a star of a picometre", tiny_star);
    for (int i = 0; i < 20; ++i) {
        comb.push_back({2.0f * static_cast<float>(i), 0.0f, 0.0f});
        comb.push_back({2.0f * static_cast<float>(i) + 1.0f, i == 19 ? 0.0f : 8.0f, 0.0f});
    }
    comb.push_back({40.0f, 10.0f, 0.0f}), comb.push_back({-1.0f, 10.0f, 0.0f});
    covers("a comb", comb);
    // The dent at every corner in turn: starting a fan at corner 0 must not be luck.
    const Polygon arrow = {{0, 0, 0}, {2, -1, 0}, {0, 2, 0}, {-2, -1, 0}};
    for (size_t turn = 0; turn < 4; ++turn) {
        Polygon turned;
        for (size_t i = 0; i < 4; ++i) turned.push_back(arrow[(i + turn) % 4]);
        covers("an arrow head with its dent at corner " + std::to_string((4 - turn) % 4), turned);
    }
    covers("a letter L", {{0, 0, 0}, {0, 0, 3}, {1, 0, 3}, {1, 0, 1}, {3, 0, 1}, {3, 0, 0}});
    covers("a square with corners in a row", {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {2, 2, 0}, {0, 2, 0}});
    covers(
        "a square with a hole and a bridge to it",
        {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {0, 0, 0}, {1, 1, 0}, {1, 3, 0}, {3, 3, 0}, {3, 1, 0}, {1, 1, 0}});
    covers("a slightly bent quadrilateral", {{0, 0, 0}, {1, 0, 0.05f}, {1, 1, 0}, {0, 1, 0.05f}});
    if (const auto got = attempt(circle); got.size() == 98)
        for (uint32_t i = 0; i < 98; ++i)
            if (got[i] != glm::uvec3(0, i + 1, i + 2)) {
                failures.push_back("triangulate(a circle) is not the fan (0, 1, 2), (0, 2, 3), ...: triangle " +
                                   std::to_string(i) + " is another");
                break;
            }

    returns("a point four times", Polygon(4, glm::vec3(1.0f)));
    returns("five corners on a line", {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {4, 0, 0}});
    returns("a bow tie", {{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}});
    returns("a five-pointed star drawn in one line",
            {{0, 1, 0}, {0.6f, -0.8f, 0}, {-1, 0.3f, 0}, {1, 0.3f, 0}, {-0.6f, -0.8f, 0}});
    const float largest = std::numeric_limits<float>::max();
    returns("the largest floats", {{0, 0, 0}, {largest, 0, 0}, {largest, largest, 0}, {-largest, largest, 0}});
    Polygon spiral;
    for (int i = 0; i < 1000; ++i) {
        const float angle = 0.1f * static_cast<float>(i < 500 ? i : 999 - i);
        spiral.push_back((i < 500 ? angle : angle + 0.5f) * glm::vec3(std::cos(angle), std::sin(angle), 0.0f));
    }
    returns("a spiral of 1000 corners", spiral);
    if (!attempt(std::span(arrow).first(2)).empty()) failures.push_back("triangulate(two corners) gave a triangle");
    return failures;
}

}  // namespace lightwalk
