#include "18_playground/placement.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "18_playground/commands.h"

namespace lightwalk {

glm::dquat rotation_of(const glm::vec3& rotation_deg) {
    const glm::dvec3 half = 0.5 * glm::radians(glm::dvec3(rotation_deg));
    const glm::dquat x(std::cos(half.x), std::sin(half.x), 0, 0), y(std::cos(half.y), 0, std::sin(half.y), 0),
        z(std::cos(half.z), 0, 0, std::sin(half.z));
    return z * y * x;
}

glm::vec3 rotation_deg_of(const glm::dquat& rotation, const glm::vec3& near_deg) {
    const glm::dmat3 m = glm::mat3_cast(glm::normalize(rotation));  // m[column][row]
    const double horizontal = std::hypot(m[0][0], m[0][1]);  // cosine of y; asin of its sine loses half of the digits
    const glm::dvec3 near = glm::radians(glm::dvec3(near_deg));
    glm::dvec3 angles(0.0, std::atan2(-m[0][2], horizontal), 0.0);
    if (horizontal > 1e-7) {
        angles.x = std::atan2(m[1][2], m[2][2]);
        angles.z = std::atan2(m[0][1], m[0][0]);
    } else {  // x and z turn about the same line: x stays as it is
        angles.x = near.x;
        const glm::dvec2 y_axis(std::cos(angles.x), std::sin(angles.x));
        const glm::dvec3 level = glm::dmat3(m) * glm::dvec3(0.0, y_axis.x, -y_axis.y);
        angles.z = std::atan2(-level.x, level.y);
    }
    const double turn = 2.0 * 3.14159265358979323846;
    const auto nearest = [&](glm::dvec3 one) {
        for (int i = 0; i < 3; ++i) one[i] += turn * std::round((near[i] - one[i]) / turn);
        return one;
    };
    const glm::dvec3 first = nearest(angles);
    const glm::dvec3 second = nearest({angles.x + 0.5 * turn, 0.5 * turn - angles.y, angles.z + 0.5 * turn});
    const glm::dvec3 a = first - near, b = second - near;
    return glm::vec3(glm::degrees(glm::dot(a, a) <= glm::dot(b, b) + 1e-9 ? first : second));
}

Placement placement_of(const glm::mat4& matrix, const glm::vec3& near_deg, bool* exact) {
    const glm::dmat3 m(matrix);
    Placement result{glm::vec3(matrix[3]), {}, {}};
    glm::dvec3 size(glm::length(m[0]), glm::length(m[1]), glm::length(m[2]));
    size = glm::max(size, glm::dvec3(least_scale));
    if (glm::determinant(m) < 0.0) size.x = -size.x;
    // Gram and Schmidt, in the order of the axes.
    const glm::dvec3 x = m[0] / size.x, y_seen = m[1] / size.y, z_seen = m[2] / size.z;
    glm::dvec3 y = y_seen - glm::dot(x, y_seen) * x;
    y = glm::length(y) > 1e-9 ? glm::normalize(y) : glm::normalize(glm::cross(x, glm::dvec3(0.1, 0.7, 0.3)));
    const glm::dvec3 z = glm::cross(x, y);
    if (exact)
        *exact = std::fabs(glm::dot(x, y_seen)) < 1e-4 && std::fabs(glm::dot(x, z_seen)) < 1e-4 &&
                 std::fabs(glm::dot(y_seen, z_seen)) < 1e-4;
    result.scale = glm::vec3(size);
    result.rotation_deg = rotation_deg_of(glm::quat_cast(glm::dmat3(x, y, z)), near_deg);
    return result;
}

Placement placement_of(const SceneObject& object) { return {object.position, object.rotation_deg, object.scale}; }

glm::mat4 matrix_of(const Placement& placement) {
    SceneObject object;
    object.position = placement.position;
    object.rotation_deg = placement.rotation_deg;
    object.scale = placement.scale;
    return local_transform(object);
}

glm::mat4 world_of(const Document& document, EntryId id) {
    glm::dmat4 world(1.0);
    for (; id != no_entry && id != root_entry; id = document.at(id).parent) {
        const Entry& entry = document.at(id);
        if (const SceneObject* object = entry.object())
            world = glm::dmat4(local_transform(*object)) * world;
        else if (const Light* light = entry.light())
            world = glm::translate(glm::dmat4(1.0), glm::dvec3(light->position)) * world;
    }
    return glm::mat4(world);
}

Said cannot_be_placed(const Placement& placement) {
    for (int i = 0; i < 3; ++i) {
        if (!(std::fabs(placement.scale[i]) >= least_scale && std::fabs(placement.scale[i]) <= 1e6f))
            return fmt::format("a scale of {:g} is not possible: 1e-6 to 1e6, or negative to mirror",
                               placement.scale[i]);
        if (!(std::fabs(placement.position[i]) <= 1e9f))
            return fmt::format("a position of {:g} m is not possible: -1e9 to 1e9", placement.position[i]);
        if (!(std::fabs(placement.rotation_deg[i]) <= 1e9f))
            return fmt::format("a rotation of {:g}° is not possible: -1e9 to 1e9", placement.rotation_deg[i]);
    }
    return "";
}

Said place(Document& document, EntryId id, const Placement& placement, uint64_t gesture) {
    if (is_locked(document, id)) return "it is locked";
    const SceneObject* object = document.at(id).object();
    if (!object) return "only objects have a rotation and a scale";
    if (const Said refused = cannot_be_placed(placement); !refused.empty()) return refused;
    if (placement_of(*object) == placement) return "";
    document.begin("place " + object->name, gesture);
    SceneObject& edited = *document.edit(id).object();
    edited.position = placement.position;
    edited.rotation_deg = placement.rotation_deg;
    edited.scale = placement.scale;
    document.commit();
    return "";
}

}  // namespace lightwalk
