#include <cmath>
#include <cstdio>
#include <limits>

#include "01_obj/exercises.h"
#include "common/check/check.h"

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

// Form of any triangulation of a polygon: n - 2 triangles of existing corners. Returns the fault, "" for none.
std::string form(const std::vector<glm::uvec3>& got, const Polygon& polygon, const std::string& call) {
    if (got.size() != polygon.size() - 2)
        return call + " gave " + std::to_string(got.size()) + " triangles, expected " +
               std::to_string(polygon.size() - 2);
    for (const glm::uvec3& t : got)
        for (int k = 0; k < 3; ++k)
            if (t[k] >= polygon.size())
                return call + " gave corner " + std::to_string(t[k]) + ", there are " + std::to_string(polygon.size()) +
                       ", counted from 0";
    return "";
}

std::string percent(double share) {
    char text[32];
    std::snprintf(text, sizeof text, "%.4g %%", 100.0 * share);
    return text;
}

}  // namespace

CHECK_EXERCISE("01.triangulate", "cut off one ear at a time: a corner that turns left and has no other corner inside") {
    // A simple polygon: every triangle is wound as the polygon, and their areas add up to its own. Both together mean
    // that nothing is covered twice and nothing is left out.
    const auto covers = [&](const std::string& what, const Polygon& polygon, const std::string& hint = "") {
        const std::string call = "triangulate(" + what + ")";
        check.call(
            call,
            [&]() -> std::string {
                const std::vector<glm::uvec3> got = triangulate(polygon);
                if (const std::string wrong = form(got, polygon, call); !wrong.empty()) return wrong;
                const glm::dvec3 whole = area_vector(polygon);
                double sum = 0.0;
                for (const glm::uvec3& t : got) {
                    const double area =
                        glm::dot(area_vector({polygon[t.x], polygon[t.y], polygon[t.z]}), whole) / glm::length(whole);
                    if (area < -1e-6 * glm::length(whole))
                        return call + " gave the triangle of the corners " + std::to_string(t.x) + ", " +
                               std::to_string(t.y) + " and " + std::to_string(t.z) +
                               ", which is wound the other way than the polygon, or lies outside of it";
                    sum += area;
                }
                const double share = sum / glm::length(whole);
                return std::abs(share - 1.0) <= 1e-4
                           ? ""
                           : call + " covers " + percent(share) + " of the polygon's area, expected 100 %";
            },
            hint);
    };
    const auto returns = [&](const std::string& what, const Polygon& polygon) {
        const std::string call = "triangulate(" + what + ")";
        check.call(
            call, [&] { return form(triangulate(polygon), polygon, call); },
            "no corner may be an ear here: take any one then, so that each round takes one away");
    };
    const std::string fan = "triangle i of a fan has the corners 0, i + 1 and i + 2",
                      dent =
                          "a fan covers what lies outside a dent: cut off an ear at a time, a corner that turns the "
                          "way the polygon does and has no other corner inside",
                      scale =
                          "compare areas with the polygon's own, not with a fixed small number, and take the corners "
                          "relative to one of them";

    covers("a triangle", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, fan);
    covers("a square", {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, fan);
    covers("a clockwise square", {{0, 1, 0}, {1, 1, 0}, {1, 0, 0}, {0, 0, 0}}, fan);
    Polygon circle, star, comb, far_star, tiny_star;
    for (int i = 0; i < 100; ++i) {
        const float angle = 6.2831853f * static_cast<float>(i) / 100.0f, radius = i % 2 ? 0.2f : 1.0f;
        circle.push_back({std::cos(angle), 0.0f, -std::sin(angle)});
        star.push_back({radius * std::cos(angle), radius * std::sin(angle), 0.3f * radius * std::cos(angle)});
        far_star.push_back(star.back() * 64.0f + glm::vec3(5000.0f, -3000.0f, 2000.0f));
        tiny_star.push_back(star.back() * 1e-12f);
    }
    covers("a circle of 100 corners", circle, fan);
    covers("a star of 100 corners", star, dent);
    covers("a star far from the origin", far_star, scale);
    covers("a star of a picometre", tiny_star, scale);
    for (int i = 0; i < 20; ++i) {
        comb.push_back({2.0f * static_cast<float>(i), 0.0f, 0.0f});
        comb.push_back({2.0f * static_cast<float>(i) + 1.0f, i == 19 ? 0.0f : 8.0f, 0.0f});
    }
    comb.push_back({40.0f, 10.0f, 0.0f});
    comb.push_back({-1.0f, 10.0f, 0.0f});
    covers("a comb", comb, dent);
    // The dent at every corner in turn: starting a fan at corner 0 must not be luck.
    const Polygon arrow = {{0, 0, 0}, {2, -1, 0}, {0, 2, 0}, {-2, -1, 0}};
    for (size_t turn = 0; turn < 4; ++turn) {
        Polygon turned;
        for (size_t i = 0; i < 4; ++i) turned.push_back(arrow[(i + turn) % 4]);
        covers("an arrow head with its dent at corner " + std::to_string((4 - turn) % 4), turned, dent);
    }
    covers("a letter L", {{0, 0, 0}, {0, 0, 3}, {1, 0, 3}, {1, 0, 1}, {3, 0, 1}, {3, 0, 0}}, dent);
    covers("a square with corners in a row", {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {2, 2, 0}, {0, 2, 0}});
    covers(
        "a square with a hole and a bridge to it",
        {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {0, 0, 0}, {1, 1, 0}, {1, 3, 0}, {3, 3, 0}, {3, 1, 0}, {1, 1, 0}});
    covers("a slightly bent quadrilateral", {{0, 0, 0}, {1, 0, 0.05f}, {1, 1, 0}, {0, 1, 0.05f}});
    // As nobody has seen them before: around a point in any plane, nearer and farther corners in turn.
    Random random(3);
    for (int i = 0; i < 12; ++i) {
        const int corners = 11 + static_cast<int>(random.uniform(0, 30));
        const glm::vec3 normal = random.direction(), other = random.direction();
        const glm::vec3 u = glm::normalize(glm::cross(normal, other)), v = glm::cross(normal, u);
        Polygon drawn;
        for (int k = 0; k < corners; ++k) {
            const double angle = 6.283185307 * (k + random.uniform(0, 0.7)) / corners, radius = random.uniform(0.3, 2);
            drawn.push_back(static_cast<float>(radius * std::cos(angle)) * u +
                            static_cast<float>(radius * std::sin(angle)) * v);
        }
        covers("a random star of " + std::to_string(corners) + " corners", drawn, dent);
    }
    check.call(
        "triangulate(a circle of 100 corners)",
        [&]() -> std::string {
            const auto got = triangulate(circle);
            for (uint32_t i = 0; i < got.size(); ++i)
                if (got[i] != glm::uvec3(0, i + 1, i + 2))
                    return "triangulate(a circle of 100 corners) is not the fan (0, 1, 2), (0, 2, 3), ...: triangle " +
                           std::to_string(i) + " is another";
            return "";
        },
        "try corner 1 first, and go on with the corner behind the one that was cut off");

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
    check.call("triangulate(two corners)", [&] {
        return triangulate(std::span(arrow).first(2)).empty() ? "" : "triangulate(two corners) gave a triangle";
    });
}

}  // namespace lightwalk
