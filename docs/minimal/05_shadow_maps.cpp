// [minimal]
// A shadow map: a ball over a floor, seen once from the sun and stored as depth; then each point of the floor and of
// the ball asks the map whether the sun sees it. Rays to the sun tell how often that is wrong. Metres throughout.
#include <cmath>
#include <cstdio>
#include <glm/glm.hpp>
#include <vector>

using glm::dvec3;

constexpr int side = 256;             // texels of the map along an edge
constexpr double half_width_m = 2.5;  // half of the map's width
constexpr double texel_m = 2 * half_width_m / side;
const dvec3 center(0, 1, 0);  // of the ball, with radius 0.6
const dvec3 to_sun = glm::normalize(dvec3(0.5, 1, 0.3));
// The view from the sun: two axes across, and the depth, which grows away from the sun.
const dvec3 right = glm::normalize(glm::cross(dvec3(0, 1, 0), to_sun)), up = glm::cross(to_sun, right);

// The first surface along a ray, in metres; infinite where there is none.
double hit(dvec3 origin, dvec3 direction) {
    const double floor_m = direction.y < 0 ? -origin.y / direction.y : INFINITY;
    const double near = glm::dot(center - origin, direction),
                 rest = 0.36 - glm::dot(origin - center, origin - center) + near * near;
    const double ball_m = rest >= 0 && near - std::sqrt(rest) > 1e-9 ? near - std::sqrt(rest) : INFINITY;
    return std::fmin(floor_m, ball_m);
}

int main() {
    // 1. Draw from the sun; keep nothing but the depth. (A rasteriser would draw triangles here.)
    std::vector<double> map(side * side);
    for (int i = 0; i < side * side; ++i) {
        const double x = (i % side + 0.5) * texel_m - half_width_m, y = (i / side + 0.5) * texel_m - half_width_m;
        map[i] = hit(x * right + y * up + 10.0 * to_sun, -to_sun) - 10;
    }
    // 2. Compare: a point is lit if nothing in the map is nearer to the sun. 3x3 comparisons soften the edge (PCF).
    // `offset_m` lifts the point off its surface first: a texel stores one depth for a square of a slanted surface,
    // half of which then seems to lie behind itself.
    const auto lit = [&](dvec3 point, dvec3 normal, double offset_m) {
        const dvec3 at = point + offset_m * normal;
        const int x = int(std::floor((glm::dot(at, right) + half_width_m) / texel_m));
        const int y = int(std::floor((glm::dot(at, up) + half_width_m) / texel_m));
        int sum = 0;
        for (int k = 0; k < 9; ++k) sum += -glm::dot(at, to_sun) <= map[(y + k / 3 - 1) * side + x + k % 3 - 1];
        return sum / 9.0;
    };
    // 3. The mean error over 90,000 points, for an offset of 0 and of two texels' diagonals.
    for (double offset_m : {0.0, 2 * std::sqrt(2.0) * texel_m}) {
        double wrong = 0;
        for (int i = 0; i < 90000; ++i) {
            const double u = (i % 300 + 0.5) / 300, v = (i / 300 + 0.5) / 300, angle = 6.283185307 * u;
            const double y = 2 * v - 1, r = std::sqrt(1 - y * y);
            const dvec3 normal = i % 2 ? dvec3(r * std::cos(angle), y, r * std::sin(angle)) : dvec3(0, 1, 0);
            if (glm::dot(normal, to_sun) <= 0) continue;  // it faces away: dark without a map
            const dvec3 point = i % 2 ? center + 0.6 * normal : 3.0 * dvec3(u - 0.5, 0, v - 0.5);
            wrong += std::fabs(lit(point, normal, offset_m) - std::isinf(hit(point + 1e-6 * normal, to_sun)));
        }
        std::printf("error %.4f\n", wrong / 90000);
    }
}
// [/minimal]
