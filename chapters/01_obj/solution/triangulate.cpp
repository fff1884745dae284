#include "01_obj/exercises.h"

// Ear clipping (Meisters 1975, "Polygons have ears"), in space rather than in a plane: areas are taken along the
// polygon's normal. In double precision, because products of four coordinates overflow a float.
namespace lightwalk::solution {
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
        for (size_t i = 0; i < points_.size(); ++i) {
            left_.push_back(static_cast<uint32_t>(i));
            normal_ += glm::cross(points_[i], points_[(i + 1) % points_.size()]);
        }
        flat_ = 1e-12 * glm::dot(normal_, normal_);
    }

    std::vector<glm::uvec3> cut() {
        std::vector<glm::uvec3> triangles;
        // A spiral of many corners has few ears; looking for them is given up after so many tests, and what is left
        // becomes triangles that are wound wrong rather than a program that does not answer.
        tests_left_ = 2000 * points_.size() + 100000;
        for (size_t at = 1; left_.size() > 2;) {
            const size_t ear = find_ear(at % left_.size());
            triangles.push_back(triangle(ear));
            left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(ear));
            at = ear;
        }
        return triangles;
    }

  private:
    glm::uvec3 triangle(size_t i) const {
        const size_t n = left_.size();
        return {left_[(i + n - 1) % n], left_[i], left_[(i + 1) % n]};
    }

    // Twice the signed area, times the length of the normal.
    double area(uint32_t a, uint32_t b, uint32_t c) const {
        return glm::dot(glm::cross(points_[b] - points_[a], points_[c] - points_[a]), normal_);
    }

    bool holds_corner(const glm::uvec3& t) {
        for (const uint32_t p : left_) {
            // A corner that stands where one of the triangle's does touches it and is not inside: outlines with a hole
            // pass the bridge to it twice.
            if (points_[p] == points_[t.x] || points_[p] == points_[t.y] || points_[p] == points_[t.z]) continue;
            if (area(t.x, t.y, p) >= 0.0 && area(t.y, t.z, p) >= 0.0 && area(t.z, t.x, p) >= 0.0) return true;
        }
        tests_left_ -= std::min(tests_left_, left_.size());
        return false;
    }

    size_t find_ear(size_t first) {
        const size_t n = left_.size();
        if (n == 3) return 1;
        for (size_t k = 0; k < n && tests_left_ > 0; ++k, --tests_left_) {
            const size_t i = (first + k) % n;
            const glm::uvec3 t = triangle(i);
            if (area(t.x, t.y, t.z) > flat_ && !holds_corner(t)) return i;
        }
        return first;
    }

    std::vector<Point> points_;
    std::vector<uint32_t> left_;  // the corners not yet cut off
    Point normal_{0.0};           // Newell: twice the area long
    double flat_ = 0.0;
    size_t tests_left_ = 0;
};

}  // namespace

std::vector<glm::uvec3> triangulate(std::span<const glm::vec3> polygon) {
    if (polygon.size() < 3) return {};
    return Polygon(polygon).cut();
}

}  // namespace lightwalk::solution
