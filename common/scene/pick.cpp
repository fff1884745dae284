#include "common/scene/pick.h"

#include <algorithm>
#include <cmath>

namespace lightwalk {

std::optional<float> hit_box(const PickRay& ray, const Bounds& box) {
    if (box.empty()) return std::nullopt;
    float enter = 0.0f, leave = std::numeric_limits<float>::infinity();
    for (int i = 0; i < 3; ++i) {
        if (ray.direction[i] == 0.0f) {
            if (ray.origin[i] < box.lower[i] || ray.origin[i] > box.upper[i]) return std::nullopt;
            continue;
        }
        float a = (box.lower[i] - ray.origin[i]) / ray.direction[i],
              b = (box.upper[i] - ray.origin[i]) / ray.direction[i];
        if (a > b) std::swap(a, b);
        // Tolerance of three roundings (T. Ize, "Robust BVH Ray Traversal", JCGT 2(2), 2013): flat boxes are hit.
        enter = std::max(enter, a);
        leave = std::min(leave, b + 4e-7f * std::fabs(b));
    }
    if (enter > leave) return std::nullopt;
    return enter;
}

std::optional<double> hit_triangle(const glm::dvec3& origin, const glm::dvec3& direction, const glm::vec3& a,
                                   const glm::vec3& b, const glm::vec3& c) {
    const glm::dvec3 ab = glm::dvec3(b) - glm::dvec3(a), ac = glm::dvec3(c) - glm::dvec3(a);
    const glm::dvec3 p = glm::cross(direction, ac);
    const double determinant = glm::dot(ab, p);
    if (determinant == 0.0) return std::nullopt;
    const glm::dvec3 from_a = origin - glm::dvec3(a);
    const double u = glm::dot(from_a, p) / determinant;
    if (!(u >= 0.0 && u <= 1.0)) return std::nullopt;
    const glm::dvec3 q = glm::cross(from_a, ab);
    const double v = glm::dot(direction, q) / determinant;
    if (!(v >= 0.0 && u + v <= 1.0)) return std::nullopt;
    const double t = glm::dot(ac, q) / determinant;
    if (!(t >= 0.0)) return std::nullopt;
    return t;
}

namespace {

std::vector<Hit> boxes_on(const Scene& scene, const PickRay& ray) {
    std::vector<Hit> found;
    for (uint32_t i = 0; i < scene.items.size(); ++i)
        if (const auto distance = hit_box(ray, scene.items[i].bounds)) found.push_back({i, *distance});
    std::stable_sort(found.begin(), found.end(),
                     [](const Hit& a, const Hit& b) { return a.distance_m < b.distance_m; });
    return found;
}

glm::vec3 facing(const PickRay& ray, const glm::dvec3& normal) {
    const glm::vec3 unit(glm::normalize(normal));
    return glm::dot(unit, ray.direction) > 0.0f ? -unit : unit;
}

}  // namespace

std::optional<Hit> pick_box(const Scene& scene, const PickRay& ray) {
    const std::vector<Hit> found = boxes_on(scene, ray);
    if (found.empty()) return std::nullopt;
    return found.front();
}

// [pick_triangle]
std::optional<Hit> pick_triangle(const Scene& scene, const PickRay& ray) {
    std::optional<Hit> nearest;
    for (const Hit& box : boxes_on(scene, ray)) {
        if (nearest && box.distance_m > nearest->distance_m) break;
        const DrawItem& item = scene.items[box.item];
        const Mesh& mesh = item.model->model.meshes[item.mesh];
        const Part& part = mesh.parts[item.part];
        const std::vector<Vertex>& vertices = vertices_of(*item.model, item.mesh);
        // Ray in mesh space. Its direction keeps its length there, so t is the distance in world space.
        const glm::dmat4 to_mesh = glm::inverse(glm::dmat4(item.transform));
        const glm::dvec3 origin(to_mesh * glm::dvec4(ray.origin, 1.0)),
            direction(to_mesh * glm::dvec4(ray.direction, 0.0));
        for (uint32_t i = part.first_index; i + 2 < part.first_index + part.index_count; i += 3) {
            const auto corner = [&](uint32_t k) { return vertices[mesh.indices[i + k]].position; };
            const auto t = hit_triangle(origin, direction, corner(0), corner(1), corner(2));
            if (!t || (nearest && *t >= double(nearest->distance_m))) continue;
            const glm::dvec3 a(corner(0)), across = glm::cross(glm::dvec3(corner(1)) - a, glm::dvec3(corner(2)) - a);
            nearest = Hit{box.item, static_cast<float>(*t), facing(ray, glm::transpose(glm::dmat3(to_mesh)) * across)};
        }
    }
    return nearest;
}
// [/pick_triangle]

}  // namespace lightwalk
