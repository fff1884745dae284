// right
#include <algorithm>
#include <cmath>

#include "01_obj/exercises.h"

// Divided by diagonals (G. Meisters, "Polygons have ears", 1975, the proof itself): an outermost corner is cut off
// where nothing lies in its triangle; else the diagonal to the corner in it that is deepest makes two smaller polygons.
namespace lightwalk::exercise {
namespace {

using Ring = std::vector<uint32_t>;

struct Plane {
    std::vector<glm::dvec2> at;
    double area(uint32_t a, uint32_t b, uint32_t c) const {
        const glm::dvec2 u = at[b] - at[a], v = at[c] - at[a];
        return u.x * v.y - u.y * v.x;
    }
    // Whether the way from corner i of the ring to b starts on the inside.
    bool opens_to(const Ring& ring, size_t i, uint32_t b) const {
        const uint32_t p = ring[i], before = ring[(i + ring.size() - 1) % ring.size()],
                       after = ring[(i + 1) % ring.size()];
        const bool left_of_after = area(p, after, b) > 0, right_of_before = area(p, before, b) < 0;
        return area(before, p, after) > 0 ? left_of_after && right_of_before : left_of_after || right_of_before;
    }
};

Plane flattened(std::span<const glm::vec3> polygon) {
    glm::dvec3 normal(0.0);
    double size = 0.0;
    std::vector<glm::dvec3> points;
    for (const glm::vec3& corner : polygon) {
        points.push_back(glm::dvec3(corner) - glm::dvec3(polygon[0]));
        for (int k = 0; k < 3; ++k) size = std::max(size, std::abs(points.back()[k]));
    }
    for (glm::dvec3& p : points) p /= size > 0 ? size : 1;
    for (size_t i = 0; i < points.size(); ++i) normal += glm::cross(points[i], points[(i + 1) % points.size()]);
    const glm::dvec3 z = glm::length(normal) > 1e-30 ? glm::normalize(normal) : glm::dvec3(0, 0, 1);
    const glm::dvec3 x = glm::normalize(glm::cross(std::abs(z.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0), z));
    Plane plane;
    for (const glm::dvec3& p : points) plane.at.push_back({glm::dot(p, x), glm::dot(p, glm::cross(z, x))});
    return plane;
}

}  // namespace

std::vector<glm::uvec3> triangulate(std::span<const glm::vec3> polygon) {
    std::vector<glm::uvec3> triangles;
    if (polygon.size() < 3) return triangles;
    const Plane plane = flattened(polygon);
    const auto n = static_cast<uint32_t>(polygon.size());
    bool convex = true;
    Ring whole;
    for (uint32_t i = 0; i < n; ++i) {
        whole.push_back(i);
        convex = convex && plane.area((i + n - 1) % n, i, (i + 1) % n) >= 0;
    }
    if (convex) {
        for (uint32_t i = 2; i < n; ++i) triangles.push_back({0, i - 1, i});
        return triangles;
    }
    std::vector<Ring> rings{whole};
    size_t looks_left = 200000000;  // about a second
    while (!rings.empty()) {
        Ring ring = std::move(rings.back());
        rings.pop_back();
        while (ring.size() >= 3) {
            const auto outermost = std::min_element(ring.begin(), ring.end(), [&](uint32_t a, uint32_t b) {
                const glm::dvec2 p = plane.at[a], q = plane.at[b];
                return p.x != q.x ? p.x < q.x : p.y < q.y;
            });
            const size_t size = ring.size(), i = static_cast<size_t>(outermost - ring.begin());
            const uint32_t a = ring[(i + size - 1) % size], b = ring[i], c = ring[(i + 1) % size];
            looks_left -= std::min(looks_left, size);
            size_t deepest = size;
            double depth = -1;
            for (size_t k = 0; size > 3 && looks_left > 0 && k < size; ++k) {
                const uint32_t p = ring[k];
                const glm::dvec2 at = plane.at[p];
                if (at == plane.at[a] || at == plane.at[b] || at == plane.at[c]) continue;
                if (plane.area(a, b, p) < 0 || plane.area(b, c, p) < 0 || plane.area(c, a, p) < 0) continue;
                const double from_ac = plane.area(c, a, p);
                if (from_ac > depth && plane.opens_to(ring, k, b)) {
                    deepest = k;
                    depth = from_ac;
                }
            }
            if (deepest == size) {
                triangles.push_back({a, b, c});
                ring.erase(ring.begin() + static_cast<long>(i));
                continue;
            }
            const size_t first = std::min(i, deepest), last = std::max(i, deepest);
            rings.emplace_back(ring.begin() + static_cast<long>(first), ring.begin() + static_cast<long>(last) + 1);
            ring.erase(ring.begin() + static_cast<long>(first) + 1, ring.begin() + static_cast<long>(last));
        }
    }
    return triangles;
}

}  // namespace lightwalk::exercise
