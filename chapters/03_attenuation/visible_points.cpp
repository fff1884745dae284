#include "03_attenuation/visible_points.h"

#include <cmath>

namespace lightwalk {
namespace {

struct Ray {
    glm::vec3 origin, direction;  // the direction's depth along the view is 1: distances along it are depths
};

// Whether the ray meets the box at less than `farthest`.
bool meets(const Ray& ray, const Bounds& box, float farthest) {
    const glm::vec3 a = (box.lower - ray.origin) / ray.direction, b = (box.upper - ray.origin) / ray.direction;
    const glm::vec3 in = glm::min(a, b), out = glm::max(a, b);
    const float enter = std::max({in.x, in.y, in.z, 0.0f}), leave = std::min({out.x, out.y, out.z, farthest});
    return enter <= leave * 1.0001f;  // a flat box has no thickness
}

// T. Möller and B. Trumbore, Fast, Minimum Storage Ray/Triangle Intersection, 1997; front faces only. Returns the
// distance and the coordinates of the second and third corner.
bool hit(const Ray& ray, const glm::vec3 corners[3], glm::vec3& found) {
    const glm::vec3 e1 = corners[1] - corners[0], e2 = corners[2] - corners[0], p = glm::cross(ray.direction, e2);
    const float determinant = glm::dot(e1, p);
    if (determinant <= 0.0f) return false;
    const glm::vec3 from = ray.origin - corners[0], q = glm::cross(from, e1);
    const float u = glm::dot(from, p), v = glm::dot(ray.direction, q);
    if (u < 0.0f || v < 0.0f || u + v > determinant) return false;
    found = glm::vec3(glm::dot(e2, q), u, v) / determinant;
    return true;
}

void trace_item(const Ray& ray, const DrawItem& item, uint32_t index, VisiblePoint& nearest) {
    const Mesh& mesh = item.model->model.meshes[item.mesh];
    const Part& part = mesh.parts[item.part];
    // In the mesh's own space distances along the ray stay the same.
    const glm::mat4 to_mesh = glm::inverse(item.transform);
    const Ray local{glm::vec3(to_mesh * glm::vec4(ray.origin, 1.0f)), glm::mat3(to_mesh) * ray.direction};
    for (uint32_t i = part.first_index; i + 2 < part.first_index + part.index_count; i += 3) {
        const Vertex* v[3];
        glm::vec3 corners[3], found;
        for (uint32_t k = 0; k < 3; ++k) {
            v[k] = &mesh.vertices[mesh.indices[i + k]];
            corners[k] = v[k]->position;
        }
        if (!hit(local, corners, found) || found.x <= 0.0f || found.x >= nearest.depth_m) continue;
        const glm::vec3 normal =
            (1.0f - found.y - found.z) * v[0]->normal + found.y * v[1]->normal + found.z * v[2]->normal;
        nearest = {ray.origin + found.x * ray.direction, glm::normalize(glm::transpose(glm::mat3(to_mesh)) * normal),
                   found.x, index};
    }
}

}  // namespace

std::vector<VisiblePoint> visible_points(const Scene& scene, const Camera& camera, float aspect, glm::uvec2 grid) {
    std::vector<VisiblePoint> points;
    const glm::vec3 forward = glm::normalize(camera.target - camera.position);
    const glm::vec3 right = glm::normalize(glm::cross(forward, camera.up)), up = glm::cross(right, forward);
    const float tan_half = std::tan(0.5f * camera.fov_y_rad);
    for (uint32_t y = 0; y < grid.y; ++y)
        for (uint32_t x = 0; x < grid.x; ++x) {
            const glm::vec2 at = 2.0f * (glm::vec2(x, y) + 0.5f) / glm::vec2(grid) - 1.0f;
            const Ray ray{camera.position, forward + tan_half * (at.x * aspect * right - at.y * up)};
            VisiblePoint nearest{.depth_m = camera.far_m};
            for (uint32_t i = 0; i < scene.items.size(); ++i)
                if (meets(ray, scene.items[i].bounds, nearest.depth_m)) trace_item(ray, scene.items[i], i, nearest);
            if (nearest.depth_m < camera.far_m) points.push_back(nearest);
        }
    return points;
}

}  // namespace lightwalk
