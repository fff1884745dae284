#include "18_playground/marks.h"

#include <algorithm>

namespace lightwalk {
namespace {

constexpr glm::vec3 axis_colors[] = {{0.85f, 0.05f, 0.05f}, {0.08f, 0.55f, 0.03f}, {0.05f, 0.18f, 0.95f}};

void add_line(std::vector<MarkLine>& lines, const std::vector<glm::vec3>& points, glm::vec3 color, float width_px,
              float alpha = 1.0f) {
    for (size_t i = 1; i < points.size(); ++i) lines.push_back({points[i - 1], width_px, points[i], alpha, color});
}

constexpr size_t most_shapes = 100;  // ranges and cones: more of them hide the scene, and take seconds to draw

std::vector<glm::vec3> circle(glm::vec3 center, glm::vec3 u, glm::vec3 v, int points) {
    std::vector<glm::vec3> line;
    for (int i = 0; i <= points; ++i) {
        const float angle = 6.2831853f * static_cast<float>(i) / static_cast<float>(points);
        line.push_back(center + std::cos(angle) * u + std::sin(angle) * v);
    }
    return line;
}

// Two directions across one of unit length.
std::pair<glm::vec3, glm::vec3> across(glm::vec3 d) {
    const glm::vec3 u = glm::normalize(glm::cross(d, std::fabs(d.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0)));
    return {u, glm::cross(d, u)};
}

}  // namespace

void add_gizmo(std::vector<MarkLine>& lines, const GizmoPlace& place, const View& view, const Handle& hot) {
    const float pixel = place.length_m / GizmoSizes().arrow;
    for (const Handle& handle : handles(place.tool)) {
        if (is_end_on(place, handle, view)) continue;
        const bool is_hot = handle == hot, whole = handle.kind == Handle::Kind::whole;
        const glm::vec3 color = is_hot  ? glm::vec3(1.0f, 0.75f, 0.1f)
                                : whole ? glm::vec3(0.75f)
                                        : axis_colors[handle.axis];
        const std::vector<glm::vec3> line = handle_line(place, handle, view);
        add_line(lines, line, color, place.scale * (is_hot ? 4.0f : 2.5f), whole && !is_hot ? 0.7f : 1.0f);
        if (handle.kind != Handle::Kind::axis) continue;
        // The tip: an arrow's head, or a cube's edges.
        const glm::vec3 axis = place.axes[handle.axis], tip = line.back();
        const auto [u, v] = across(axis);
        for (int i = 0; i < 8; ++i) {
            const float angle = 0.7853982f * static_cast<float>(i);
            const glm::vec3 out = 4.5f * pixel * (std::cos(angle) * u + std::sin(angle) * v);
            const glm::vec3 back = tip - (place.tool == Tool::move ? 14.0f : 8.0f) * pixel * axis;
            add_line(lines, {back + out, place.tool == Tool::move ? tip : tip + out}, color, 3.0f * place.scale);
            if (place.tool == Tool::scale) add_line(lines, {back, back + out}, color, 2.0f * place.scale);
        }
    }
}

namespace {

// An arrow to the camera's target, from a disc on the side of the sun.
void add_sun(std::vector<MarkLine>& lines, const Light& light, const View& view, float scale) {
    const glm::vec3 target = view.camera.target, d = glm::normalize(light.direction), color(1.0f, 0.6f, 0.1f);
    const float pixel = scale * view.pixel_rad() * glm::distance(view.eye, target);
    const auto [u, v] = across(d);
    const glm::vec3 from = target - 150.0f * pixel * d, tip = target - 20.0f * pixel * d,
                    back = tip - 14.0f * pixel * d;
    add_line(lines, circle(from, 10.0f * pixel * u, 10.0f * pixel * v, 24), color, 2.0f * scale);
    add_line(lines, {from, tip}, color, 2.0f * scale);
    for (const glm::vec3& side : {u, -u, v, -v})
        add_line(lines, {back + 5.0f * pixel * side, tip}, color, 2.0f * scale);
}

}  // namespace

void add_lights(std::vector<MarkLine>& lines, const Document& document, const Selection& selection, const View& view,
                float scale) {
    const glm::vec3 forward = glm::normalize(view.camera.target - view.camera.position);
    const auto [right, up] = across(forward);
    const size_t all = document.at(root_entry).children.size();
    for (const EntryId id : document.at(root_entry).children) {
        const Entry& entry = document.at(id);
        const Light* light = entry.light();
        if (!light || entry.hidden) continue;
        if (is_sun(entry)) {
            if (selection.has(id)) add_sun(lines, *light, view, scale);
            continue;
        }
        const float depth = glm::dot(light->position - view.eye, forward);
        if (depth < view.camera.near_m) continue;
        const bool chosen = selection.has(id);
        const float pixel = scale * view.pixel_rad() * depth, radius = (all > 500 ? 3.0f : 7.0f) * pixel;
        const glm::vec3 color = chosen ? glm::vec3(1.0f, 0.36f, 0.03f) : glm::mix(light->color, glm::vec3(1.0f), 0.3f);
        add_line(lines, circle(light->position, radius * right, radius * up, all > 500 ? 6 : 16), color, 1.5f * scale,
                 chosen ? 1.0f : 0.8f);
        if (!chosen || (selection.ids.size() > most_shapes && id != selection.active())) continue;
        if (light->kind == Light::Kind::point) {
            for (int i = 0; i < 3; ++i) {
                glm::vec3 u(0.0f), v(0.0f);
                u[(i + 1) % 3] = v[(i + 2) % 3] = light->range_m;
                add_line(lines, circle(light->position, u, v, 64), color, scale, 0.6f);
            }
            continue;
        }
        const glm::vec3 d = glm::normalize(light->direction);
        const auto [u, v] = across(d);
        for (const float angle : {light->inner_rad, light->outer_rad}) {
            const float along = light->range_m * std::cos(angle), out = light->range_m * std::sin(angle);
            const std::vector<glm::vec3> rim = circle(light->position + along * d, out * u, out * v, 48);
            add_line(lines, rim, color, scale, 0.8f);
            for (size_t i = 0; i < 48; i += 12) add_line(lines, {light->position, rim[i]}, color, scale, 0.8f);
        }
    }
}

void Marks::record(Frame& frame, const View& view, const Image& picture, const Picker& picker,
                   const std::vector<uint32_t>& selected, const std::vector<MarkLine>& lines, float scale) {
    if (std::any_of(selected.begin(), selected.end(), [](uint32_t one) { return one != 0; })) {
        frame.upload(path() + " selected", selected_, selected);
        frame.compute("outline", {.reads = {picker.ids, selected_, picture}, .writes = {picture}}, [&](Compute& pass) {
            pass.use(outline_)
                .set("ids", picker.ids, nearest_clamp)
                .set("selected", selected_)
                .set("width", scale * width.value);
            pass.set("picture", picture).dispatch_threads(picture.desc.size);
        });
    }
    if (lines.empty()) return;
    frame.upload(path() + " lines", lines_, lines);
    const ViewScope scope(frame, view);
    frame.raster("marks", {.color = {keep(picture)}, .reads = {lines_}}, [&](Raster& pass) {
        pass.use(line_).set("lines", lines_).draw(static_cast<uint32_t>(6 * lines.size()));
    });
}

}  // namespace lightwalk
