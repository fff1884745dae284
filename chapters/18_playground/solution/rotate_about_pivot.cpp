#include "18_playground/exercises.h"

namespace lightwalk::solution {

Pose rotate_about_pivot(const Pose& pose, glm::vec3 pivot, glm::vec3 axis, float angle_rad) {
    const glm::dquat turn = glm::angleAxis(double(angle_rad), glm::dvec3(axis));
    const glm::dvec3 arm = glm::dvec3(pose.position) - glm::dvec3(pivot);
    return {glm::vec3(glm::dvec3(pivot) + glm::normalize(turn) * arm),
            glm::quat(glm::normalize(turn * glm::dquat(pose.orientation)))};
}

}  // namespace lightwalk::solution
