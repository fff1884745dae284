#include <algorithm>

#include "15_terrain_water/exercises.h"

namespace lightwalk::solution {

glm::mat4 mirror_view(const glm::mat4& view_projection, float water_m) {
    // 1. Mirrored in the water, then from left to right.
    glm::dmat4 mirror(1.0), turn(1.0);
    mirror[1][1] = -1.0;
    mirror[3][1] = 2.0 * double(water_m);
    turn[0][0] = -1.0;
    const glm::dmat4 mirrored = turn * glm::dmat4(view_projection) * mirror;

    // 2. The water as the near plane: the third row is the fourth less s times the plane. A corner of the far plane, with
    //    w = 1, keeps z >= 0 where s is at most 1 over its height above the water.
    const glm::dvec4 plane(0.0, 1.0, 0.0, -double(water_m));
    const glm::dmat4 back = glm::inverse(mirrored);
    double highest = 0;
    for (const double x : {-1.0, 1.0})
        for (const double y : {-1.0, 1.0}) highest = std::max(highest, glm::dot(plane, back * glm::dvec4(x, y, 0, 1)));
    // Where none of them lies above the water the camera sees nothing mirrored, and any s will do.
    const double s = highest > 0 ? 1.0 / highest : 1.0;
    glm::dmat4 rows = glm::transpose(mirrored);
    rows[2] = rows[3] - s * plane;
    return glm::mat4(glm::transpose(rows));
}

}  // namespace lightwalk::solution
