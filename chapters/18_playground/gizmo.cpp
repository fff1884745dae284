#include "18_playground/gizmo.h"

#include <algorithm>
#include <cmath>

#include "18_playground/terrain_entry.h"

namespace lightwalk {
namespace {

constexpr GizmoSizes sizes;
constexpr int ring_points = 64;
constexpr float end_on_rad = 0.14f;  // 8°

// Two axes across the third.
std::pair<glm::vec3, glm::vec3> across(const GizmoPlace& place, int axis) {
    return {place.axes[(axis + 1) % 3], place.axes[(axis + 2) % 3]};
}

float distance_to_segment(glm::vec2 p, glm::vec2 a, glm::vec2 b) {
    const glm::vec2 ab = b - a;
    const float square = glm::dot(ab, ab);
    const float t = square > 0.0f ? std::clamp(glm::dot(p - a, ab) / square, 0.0f, 1.0f) : 0.0f;
    return glm::length(p - a - t * ab);
}

bool is_inside(const std::vector<glm::vec2>& polygon, glm::vec2 p) {
    bool inside = false;
    for (size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
        const glm::vec2 a = polygon[i], b = polygon[j];
        if ((a.y > p.y) != (b.y > p.y) && p.x < (b.x - a.x) * (p.y - a.y) / (b.y - a.y) + a.x) inside = !inside;
    }
    return inside;
}

}  // namespace

std::optional<glm::vec2> on_screen(const View& view, const glm::vec3& place) {
    const glm::vec4 clip = view.view_projection * glm::vec4(place, 1.0f);
    if (!(clip.w > 1e-6f)) return std::nullopt;
    return (glm::vec2(clip) / clip.w * 0.5f + 0.5f) * glm::vec2(view.size);
}

PickRay ray_through(const View& view, glm::vec2 cursor_px) {
    return pick_ray(glm::mat4(glm::inverse(glm::dmat4(view.view_projection))), cursor_px, view.size);
}

std::optional<GizmoPlace> gizmo_place(const Document& document, const Selection& selection, const View& view, Tool tool,
                                      bool local, float scale) {
    GizmoPlace place{.tool = tool};
    glm::dvec3 sum(0.0);
    int count = 0;
    bool any_sun = false;
    for (const EntryId id : selection.ids)
        if (const Entry* entry = document.find(id);
            entry && (entry->object() || entry->light()) && !is_terrain(*entry)) {
            if (is_sun(*entry)) {
                any_sun = true;
                continue;
            }
            sum += glm::dvec3(world_of(document, id)[3]);
            ++count;
        }
    if (count == 0 && !any_sun) return std::nullopt;
    if (count == 0) {
        place.tool = tool = Tool::rotate;
        place.pivot = view.camera.target;
    } else {
        place.pivot = glm::vec3(sum / double(count));
    }
    if (local || tool == Tool::scale) {
        const glm::mat3 m(world_of(document, selection.active()));
        for (int i = 0; i < 3; ++i)
            if (glm::length(m[i]) > 0.0f) place.axes[i] = glm::normalize(m[i]);
    }
    const float depth = glm::dot(place.pivot - view.eye, glm::normalize(view.camera.target - view.camera.position));
    place.scale = scale;
    place.length_m = scale * sizes.arrow * view.pixel_rad() * std::max(depth, view.camera.near_m);
    return place;
}

std::vector<Handle> handles(Tool tool) {
    std::vector<Handle> all;
    for (int i = 0; i < 3; ++i) {
        all.push_back({tool == Tool::rotate ? Handle::Kind::ring : Handle::Kind::axis, i});
        if (tool == Tool::move) all.push_back({Handle::Kind::plane, i});
    }
    all.push_back({Handle::Kind::whole, 0});
    return all;
}

bool is_end_on(const GizmoPlace& place, const Handle& handle, const View& view) {
    const glm::vec3 away = place.pivot - view.eye;
    if (handle.kind == Handle::Kind::whole || glm::length(away) == 0.0f) return false;
    const float cosine = std::fabs(glm::dot(glm::normalize(away), place.axes[handle.axis]));
    if (handle.kind == Handle::Kind::axis) return cosine > std::cos(end_on_rad);
    return handle.kind == Handle::Kind::plane && cosine < std::sin(end_on_rad);
}

std::vector<glm::vec3> handle_line(const GizmoPlace& place, const Handle& handle, const View& view) {
    const float length = place.length_m, pixel = length / sizes.arrow;  // of the window at scale 1
    std::vector<glm::vec3> line;
    if (handle.kind == Handle::Kind::axis) return {place.pivot, place.pivot + length * place.axes[handle.axis]};
    auto [u, v] = across(place, handle.axis);
    float radius = length;
    if (handle.kind == Handle::Kind::plane) {
        const glm::vec3 corner = place.pivot + 12.0f * pixel * (u + v);
        const float side = sizes.plane * pixel;
        return {corner, corner + side * u, corner + side * (u + v), corner + side * v, corner};
    }
    if (handle.kind == Handle::Kind::whole) {
        const glm::vec3 forward = glm::normalize(place.pivot - view.eye);
        u = glm::normalize(glm::cross(forward, std::fabs(forward.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0)));
        v = glm::cross(forward, u);
        radius = place.tool == Tool::rotate ? 1.15f * length : 9.0f * pixel;
    }
    for (int i = 0; i <= ring_points; ++i) {
        const float angle = 6.2831853f * static_cast<float>(i) / ring_points;
        line.push_back(place.pivot + radius * (std::cos(angle) * u + std::sin(angle) * v));
    }
    return line;
}

// [handle_at]
Handle handle_at(const GizmoPlace& place, const View& view, glm::vec2 cursor_px) {
    Handle nearest;
    float least = sizes.reach * place.scale;
    for (const Handle& handle : handles(place.tool)) {
        if (is_end_on(place, handle, view)) continue;
        std::vector<glm::vec2> line;
        for (const glm::vec3& point : handle_line(place, handle, view))
            if (const auto pixel = on_screen(view, point)) line.push_back(*pixel);
        if (line.size() < 2) continue;
        float distance = 1e9f;
        for (size_t i = 1; i < line.size(); ++i)
            distance = std::min(distance, distance_to_segment(cursor_px, line[i - 1], line[i]));
        const bool filled =
            handle.kind == Handle::Kind::plane || (handle.kind == Handle::Kind::whole && place.tool != Tool::rotate);
        if (filled && is_inside(line, cursor_px)) distance = 0.0f;
        if (distance < least) {
            least = distance;
            nearest = handle;
        }
    }
    return nearest;
}
// [/handle_at]

}  // namespace lightwalk
