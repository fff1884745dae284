// right
#include <algorithm>
#include <cmath>

#include "01_obj/exercises.h"

// Ear clipping (Meisters 1975, "Polygons have ears"), in space rather than in a plane: areas are taken along the
// polygon's normal. In double precision, because products of four coordinates overflow a float.
namespace lightwalk::exercise {
namespace {

using Point = glm::dvec3;

class Polygon {
  public:
    explicit Polygon(std::span<const glm::vec3> corners) {
        // Relative to a corner and to the size, so that neither a far position nor the unit matters.
        double size = 0.0;
        for (const glm::vec3& c : corners) {
            points_.push_back(Point(c) - Point(corners[0]));
            for (int k = 0; k < 3; ++k) size = std::max(size, std::abs(points_.back()[k]));
        }
        if (size > 0.0)
            for (Point& p : points_) p /= size;
        const uint32_t count = static_cast<uint32_t>(points_.size());
        for (uint32_t i = 0; i < count; ++i) {
            normal_ += glm::cross(points_[i], points_[(i + 1) % count]);
            next_.push_back((i + 1) % count);
            previous_.push_back((i + count - 1) % count);
        }
        flat_ = 1e-12 * glm::dot(normal_, normal_);
        for (uint32_t i = 0; i < count; ++i)
            if (area(previous_[i], i, next_[i]) <= flat_) dents_.push_back(i);
    }

    std::vector<glm::uvec3> cut() {
        std::vector<glm::uvec3> triangles;
        // A long spiral has few ears. Looking for them is given up after so many tests, about a second, and the rest
        // becomes triangles that are wound wrong rather than a program that does not answer.
        tests_left_ = std::min<size_t>(5000 * points_.size() + 100000, 200000000);
        uint32_t at = 1;
        for (size_t left = points_.size(); left > 2; --left) {
            const uint32_t ear = find_ear(at, left);
            triangles.push_back({previous_[ear], ear, next_[ear]});
            next_[previous_[ear]] = next_[ear];
            previous_[next_[ear]] = previous_[ear];
            at = next_[ear];
            next_[ear] = cut_off;
        }
        return triangles;
    }

  private:
    static constexpr uint32_t cut_off = none;

    // Twice the signed area, times the length of the normal.
    double area(uint32_t a, uint32_t b, uint32_t c) const {
        return glm::dot(glm::cross(points_[b] - points_[a], points_[c] - points_[a]), normal_);
    }

    // Of the corners only dents need to be tested: where any corner lies in the triangle, a dent does too.
    bool holds_corner(uint32_t a, uint32_t b, uint32_t c) {
        tests_left_ -= std::min(tests_left_, dents_.size());
        for (const uint32_t p : dents_) {
            // A corner that stands where one of the triangle's does touches it and is not inside: outlines with a hole
            // pass the bridge to it twice.
            if (next_[p] == cut_off || points_[p] == points_[a] || points_[p] == points_[b] || points_[p] == points_[c])
                continue;
            if (area(a, b, p) >= 0.0 && area(b, c, p) >= 0.0 && area(c, a, p) >= 0.0) return true;
        }
        return false;
    }

    uint32_t find_ear(uint32_t first, size_t left) {
        if (left == 3) return first;
        uint32_t i = first;
        for (size_t k = 0; k < left && tests_left_ > 0; ++k, i = next_[i]) {
            --tests_left_;
            if (area(previous_[i], i, next_[i]) > flat_ && !holds_corner(previous_[i], i, next_[i])) return i;
        }
        return first;
    }

    std::vector<Point> points_;
    std::vector<uint32_t> next_, previous_;  // the ring of corners not yet cut off
    std::vector<uint32_t> dents_;            // where the outline turns away, or goes straight on
    Point normal_{0.0};                      // Newell: twice the area long
    double flat_ = 0.0;
    size_t tests_left_ = 0;
};

}  // namespace

std::vector<glm::uvec3> triangulate(std::span<const glm::vec3> polygon) {
    if (polygon.size() < 3) return {};
    return Polygon(polygon).cut();
}

}  // namespace lightwalk::exercise
