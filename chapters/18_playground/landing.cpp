#include <algorithm>
#include <cmath>

#include "18_playground/editor_part.h"
#include "18_playground/gizmo.h"

namespace lightwalk {
namespace {

constexpr float farthest = 10.0f;  // times the distance of the camera's target

bool is_in_picture(const View& view, const glm::vec3& place) {
    const auto pixel = on_screen(view, place);
    const glm::vec2 size(view.size), margin = 0.05f * size;
    return pixel && glm::all(glm::greaterThan(*pixel, margin)) && glm::all(glm::lessThan(*pixel, size - margin));
}

bool is_taken(const Scene& scene, const glm::vec3& place, float near_m) {
    const auto& lights = scene.file.lights;
    return std::any_of(lights.begin(), lights.end(), [&](const Light& one) {
        return one.kind != Light::Kind::directional && glm::distance(one.position, place) < near_m;
    });
}

}  // namespace

Landing landing_on(const Scene& scene, const Camera& camera, const PickRay& ray, const GroundHeights& terrain) {
    const float target_m = glm::distance(camera.position, camera.target), most = farthest * target_m;
    const auto at = [&](float distance, const glm::vec3& normal) {
        return Landing{ray.origin + distance * ray.direction, normal, distance};
    };
    const auto hit = pick_triangle(scene, ray);
    const float nearest = hit ? std::min(hit->distance_m, most) : most;
    if (const auto met = terrain.met_by(ray, nearest)) return at(met->distance_m, met->normal);
    if (hit && hit->distance_m < most) return at(hit->distance_m, hit->normal);
    const float ground = scene.bounds.empty() ? camera.target.y : scene.bounds.lower.y;
    const float to_ground = ray.direction.y < 0.0f ? (ground - ray.origin.y) / ray.direction.y : -1.0f;
    const bool reaches = to_ground > 0.0f && to_ground < most && !hit;
    return at(reaches ? to_ground : target_m, {0.0f, 1.0f, 0.0f});
}

Placement placed_model(const Landing& landing, const Camera& camera, const Bounds& box) {
    Placement placement{.position = landing.point};
    if (box.empty()) return placement;
    const float shown_m = 2.0f * landing.distance_m * std::tan(0.5f * camera.fov_y_rad);
    const float size = std::max(glm::length(box.extent()), 1e-6f);
    const float share = size / shown_m;  // of the picture's height
    float factor = 1.0f;
    if (share > 1.5f || share < 0.02f) factor = std::pow(10.0f, -std::round(std::log10(share / 0.3f)));
    placement.scale = glm::vec3(std::clamp(factor, least_scale, 1e6f));
    const glm::vec3 half = 0.5f * placement.scale * box.extent();
    const glm::vec3 middle = landing.point + glm::dot(glm::abs(landing.normal), half) * landing.normal;
    placement.position = middle - placement.scale * box.center();
    return placement;
}

Light placed_light(Light::Kind kind, const Landing& landing, const Scene& scene, const View& view) {
    Light light{.kind = kind, .color = {1.0f, 0.85f, 0.65f}, .shadow = true};
    if (kind == Light::Kind::directional) {
        light.direction = glm::normalize(glm::vec3(-0.5f, -1.0f, -0.4f));
        return light;
    }
    float above = (kind == Light::Kind::spot ? 0.3f : 0.15f) * landing.distance_m;
    const PickRay up{landing.point + 1e-3f * landing.distance_m * landing.normal, landing.normal};
    if (const auto opposite = pick_triangle(scene, up)) above = std::min(above, 0.5f * opposite->distance_m);
    const auto place = [&] { return landing.point + above * landing.normal; };
    for (int i = 0; i < 6 && !is_in_picture(view, place()); ++i) above *= 0.5f;
    light.position = place();
    const glm::vec3 right = glm::normalize(glm::cross(view.camera.target - view.camera.position, view.camera.up));
    const float beside = 0.05f * landing.distance_m;
    for (int i = 0; i < 100 && is_taken(scene, light.position, 0.5f * beside); ++i) light.position += beside * right;
    light.direction = -landing.normal;
    light.range_m = landing.distance_m;
    light.size_m = 0.1f * above;
    light.intensity = std::max(above * above, 1e-4f);  // as bright as a sun of 1 at the surface
    return light;
}

}  // namespace lightwalk
