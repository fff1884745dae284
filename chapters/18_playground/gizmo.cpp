#include "18_playground/gizmo.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "18_playground/commands.h"

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

namespace {

constexpr const char* axis_names = "xyz";

// Steps of 1, 10, 0.1 ... a tenth of an arrow, rounded down: so that a step can be seen at any distance.
double snap_step(float length_m) { return std::pow(10.0, std::floor(std::log10(double(length_m)))) * 0.1; }

double snapped(double value, double step) { return step * std::round(value / step); }

// Across a mirror in x, in which a turn about x goes on and all others go backwards.
glm::dquat seen(const glm::dquat& turn, bool mirrored) {
    return mirrored ? glm::dquat(turn.w, turn.x, -turn.y, -turn.z) : turn;
}

}  // namespace

GizmoDrag::GizmoDrag(Document& document, const std::vector<EntryId>& ids, const GizmoPlace& place, const Handle& handle,
                     const View& view, glm::vec2 cursor_px)
    : document_(document), place_(place), handle_(handle), start_px_(cursor_px), last_px_(cursor_px), view_(view) {
    for (const EntryId id : movable(document, ids)) {
        const Entry& entry = document.at(id);
        Start start{id, glm::dmat4(world_of(document, entry.parent)), {}, glm::dquat(1, 0, 0, 0)};
        if (const SceneObject* object = entry.object()) start.placement = placement_of(*object);
        if (const Light* light = entry.light()) {
            start.light_position = light->position;
            start.light_direction = light->direction;
        }
        const Placement parent = placement_of(glm::mat4(start.parent), glm::vec3(0.0f));
        start.parent_rotation = rotation_of(parent.rotation_deg);
        start.mirrored = parent.scale.x < 0.0f;
        starts_.push_back(start);
    }
    normal_ = handle.kind == Handle::Kind::whole ? glm::normalize(place.pivot - view.eye) : place.axes[handle.axis];
    const char* const verbs[] = {"move", "rotate", "scale"};
    document.begin(fmt::format(
        "{} {}", verbs[static_cast<int>(place.tool)],
        starts_.size() == 1 ? document.at(starts_[0].id).name() : fmt::format("{} entries", starts_.size())));
    start_on_axis_ = place_on_axis(view, cursor_px);
    start_place_ = place_on(view, cursor_px);
    last_angle_ = angle_on(view, cursor_px).value_or(0.0f);
}

// The window changed its size or view: dragged objects stay in place under a resting mouse.
void GizmoDrag::follow(const View& view) {
    start_on_axis_ += place_on_axis(view, last_px_) - place_on_axis(view_, last_px_);
    start_place_ += place_on(view, last_px_) - place_on(view_, last_px_);
    last_angle_ = angle_on(view, last_px_).value_or(last_angle_);
}

float GizmoDrag::place_on_axis(const View& view, glm::vec2 cursor_px) const {
    return drag_on_axis(ray_through(view, cursor_px), place_.pivot, place_.axes[handle_.axis]);
}

// About the pivot, on the screen; none too near to it.
std::optional<float> GizmoDrag::angle_on(const View& view, glm::vec2 cursor_px) const {
    const auto center = on_screen(view, place_.pivot);
    if (!center || glm::length(cursor_px - *center) < 2.0f) return std::nullopt;
    return std::atan2(cursor_px.y - center->y, cursor_px.x - center->x);
}

// Where the ray meets the plane of the handle; seen from its edge the plane is met no farther than a hundred arrows away.
glm::vec3 GizmoDrag::place_on(const View& view, glm::vec2 cursor_px) const {
    const PickRay ray = ray_through(view, cursor_px);
    const float along = glm::dot(ray.direction, normal_);
    const float least = 0.02f;
    const float t =
        glm::dot(place_.pivot - ray.origin, normal_) / (std::fabs(along) < least ? std::copysign(least, along) : along);
    const glm::vec3 found = ray.origin + t * ray.direction, from = found - place_.pivot;
    const float far = glm::length(from), most = 100.0f * place_.length_m;
    return far > most ? place_.pivot + from * (most / far) : found;
}

// [drag]
void GizmoDrag::move(const View& view, glm::vec2 cursor_px, bool snap) {
    if (view.view_projection != view_.view_projection || view.size != view_.size) follow(view);
    view_ = view;
    last_px_ = cursor_px;
    const glm::dvec3 axis(place_.axes[handle_.axis]);
    const bool along_axis = handle_.kind == Handle::Kind::axis;
    if (place_.tool == Tool::rotate) {
        const auto now = angle_on(view, cursor_px);
        if (!now) return;
        angle_ += std::remainder(*now - last_angle_, glm::two_pi<float>());  // more than one turn is possible
        last_angle_ = *now;
        // On the screen y points down; seen against the axis the ring turns the other way.
        const float side = glm::dot(place_.pivot - view.eye, normal_) > 0.0f ? 1.0f : -1.0f;
        double angle = double(side * angle_);
        if (snap) angle = snapped(angle, glm::radians(15.0));
        rotate(normal_, angle);
        words_ = fmt::format("{:.1f}°", glm::degrees(angle));
    } else if (along_axis) {
        double by = double(place_on_axis(view, cursor_px) - start_on_axis_);
        if (place_.tool == Tool::move) {
            if (snap) by = snapped(by, snap_step(place_.length_m));
            translate(by * axis);
            words_ = fmt::format("{:.4g} m along {}", by, axis_names[handle_.axis]);
        } else {
            double factor = 1.0 + by / double(place_.length_m);
            if (snap) factor = snapped(factor, 0.1);
            glm::dvec3 all(1.0);
            all[handle_.axis] = factor;
            scale(all);
            words_ = fmt::format("×{:.3g} along {}", factor, axis_names[handle_.axis]);
        }
    } else if (place_.tool == Tool::move) {
        glm::dvec3 by = glm::dvec3(place_on(view, cursor_px)) - glm::dvec3(start_place_);
        if (snap)
            for (int i = 0; i < 3; ++i) by[i] = snapped(by[i], snap_step(place_.length_m));
        translate(by);
        words_ = fmt::format("{:.4g}, {:.4g}, {:.4g} m", by.x, by.y, by.z);
    } else {
        double factor = std::exp(0.01 * double(cursor_px.x - start_px_.x - cursor_px.y + start_px_.y));
        if (snap) factor = std::max(snapped(factor, 0.1), 0.1);
        scale(glm::dvec3(factor));
        words_ = fmt::format("×{:.3g}", factor);
    }
}
// [/drag]

void GizmoDrag::translate(const glm::dvec3& by) {
    for (const Start& start : starts_) {
        Entry& entry = document_.edit(start.id);
        if (SceneObject* object = entry.object()) {
            const glm::dvec3 own = glm::inverse(glm::dmat3(start.parent)) * by;
            object->position = glm::vec3(glm::dvec3(start.placement.position) + own);
        } else if (Light* light = entry.light(); light && !is_sun(entry)) {
            light->position = glm::vec3(glm::dvec3(start.light_position) + by);
        }
    }
}

void GizmoDrag::rotate(const glm::vec3& axis, double angle_rad) {
    const float angle = static_cast<float>(angle_rad);
    for (const Start& start : starts_) {
        Entry& entry = document_.edit(start.id);
        if (SceneObject* object = entry.object()) {
            if (angle == 0.0f) {  // to the bit
                object->position = start.placement.position;
                object->rotation_deg = start.placement.rotation_deg;
                continue;
            }
            const glm::dvec3 world(start.parent * glm::dvec4(start.placement.position, 1.0));
            const glm::dquat before =
                start.parent_rotation * seen(rotation_of(start.placement.rotation_deg), start.mirrored);
            const Pose turned = rotate_about_pivot({glm::vec3(world), glm::quat(before)}, place_.pivot, axis, angle);
            object->position = glm::vec3(glm::inverse(start.parent) * glm::dvec4(turned.position, 1.0));
            const glm::dquat own = glm::inverse(start.parent_rotation) * glm::dquat(turned.orientation);
            object->rotation_deg = rotation_deg_of(seen(own, start.mirrored), object->rotation_deg);
        } else if (Light* light = entry.light()) {
            const Pose turned = rotate_about_pivot({start.light_position}, place_.pivot, axis, angle);
            light->position = angle == 0.0f || is_sun(entry) ? start.light_position : turned.position;
            light->direction =
                angle == 0.0f ? start.light_direction : glm::normalize(turned.orientation * start.light_direction);
        }
    }
}

void GizmoDrag::scale(const glm::dvec3& by) {
    const bool alike = by.x == by.y && by.y == by.z;
    const auto limited = [](double value) {
        const double size = std::clamp(std::fabs(value), double(least_scale), 1e6);
        return static_cast<float>(value < 0.0 ? -size : size);
    };
    for (const Start& start : starts_) {
        Entry& entry = document_.edit(start.id);
        if (SceneObject* object = entry.object()) {
            for (int i = 0; i < 3; ++i) object->scale[i] = limited(double(start.placement.scale[i]) * by[i]);
            if (!alike || starts_.size() < 2) continue;
            const glm::dvec3 world(start.parent * glm::dvec4(start.placement.position, 1.0)), pivot(place_.pivot);
            const glm::dvec4 moved(pivot + by.x * (world - pivot), 1.0);
            object->position = by.x == 1.0 ? start.placement.position : glm::vec3(glm::inverse(start.parent) * moved);
        } else if (Light* light = entry.light(); light && alike && starts_.size() > 1 && !is_sun(entry)) {
            const glm::dvec3 pivot(place_.pivot);
            light->position = glm::vec3(pivot + by.x * (glm::dvec3(start.light_position) - pivot));
        }
    }
}

void GizmoDrag::finish() { document_.commit(); }
void GizmoDrag::cancel() { document_.cancel(); }

}  // namespace lightwalk
