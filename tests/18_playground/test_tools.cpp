// Handles, drags and rays: snapping, which way a turn goes, parents, limits, edges.
#include <glm/gtc/matrix_transform.hpp>

#include "01_obj/camera_view.h"
#include "18_playground/gizmo.h"
#include "common/scene/pick.h"
#include "editor_fixture.h"

using namespace lightwalk;

namespace {

View view_from(glm::vec3 eye, glm::vec3 target = glm::vec3(0.0f)) {
    Camera camera;
    camera.position = eye;
    camera.target = target;
    return view_of(camera, {960, 540});
}

// One drag of a handle from where it is on the screen, by so many pixels.
struct Dragged {
    Document& document;
    std::vector<EntryId> ids;
    View view = view_from({0, 0, 10});
    Tool tool = Tool::move;
    bool local = false;
    std::string by(const Handle& handle, glm::vec2 from, const std::vector<glm::vec2>& path, bool snap = false) const {
        Selection selection;
        selection.set(ids);
        GizmoDrag drag(document, ids, *gizmo_place(document, selection, view, tool, local), handle, view, from);
        for (const glm::vec2& at : path) drag.move(view, at, snap);
        drag.finish();
        return drag.words();
    }
};

constexpr Handle x_axis{Handle::Kind::axis, 0}, z_ring{Handle::Kind::ring, 2}, whole{Handle::Kind::whole, 0};
constexpr glm::vec2 center(480, 270);

std::vector<glm::vec2> circle(double from_deg, double to_deg) {
    std::vector<glm::vec2> path;
    const int steps = 4 + int(std::fabs(to_deg - from_deg) / 20);
    for (int i = 0; i <= steps; ++i) {
        const double rad = glm::radians(from_deg + (to_deg - from_deg) * i / steps);
        path.push_back(center + 90.0f * glm::vec2(std::cos(rad), std::sin(rad)));
    }
    return path;
}

}  // namespace

TEST_CASE("with Shift a drag goes in steps: 15 degrees, a tenth of a power of ten below the arrow's length, tenths") {
    Document document;
    const std::vector<EntryId> ids = add_all(document, {"a"});
    Dragged drag{document, ids};
    drag.by(x_axis, center + glm::vec2(45, 0), {center + glm::vec2(73, 3)}, true);
    const float x = document.at(ids[0]).object()->position.x;
    CHECK(x > 0.2f);  // an arrow is longer than 1 m here
    CHECK(x < 0.9f);
    CHECK(std::fabs(10 * x - std::round(10 * x)) < 1e-5f);
    drag.tool = Tool::rotate;
    document.undo();
    drag.by(z_ring, center + glm::vec2(90, 0), circle(0, 40), true);
    CHECK(std::fabs(std::fabs(document.at(ids[0]).object()->rotation_deg.z) - 45) < 1e-3f);
    document.undo();
    drag.tool = Tool::scale;
    drag.by(x_axis, center + glm::vec2(45, 0), {center + glm::vec2(75, 0)}, true);
    CHECK(std::fabs(document.at(ids[0]).object()->scale.x - 1.3f) < 1e-5f);
}

TEST_CASE("a ring turns what is selected as the mouse goes round it, seen from either side and more than once round") {
    for (const float side : {10.0f, -10.0f}) {
        Document document;
        const std::vector<EntryId> ids = add_all(document, {"a"});
        Dragged drag{document, ids, view_from({0, 0, side}), Tool::rotate};
        drag.by(z_ring, center + glm::vec2(90, 0), circle(0, 70));
        // An object seen to the right of the middle is seen 70 degrees further round.
        const glm::mat4 world = world_of(document, ids[0]);
        const glm::vec2 was = *on_screen(drag.view, {side > 0 ? 1 : -1, 0, 0}) - center;
        const glm::vec2 now = *on_screen(drag.view, glm::vec3(world * glm::vec4(side > 0 ? 1 : -1, 0, 0, 1))) - center;
        CHECK(was.x > 10);
        CHECK(std::fabs(glm::degrees(std::atan2(now.y, now.x)) - 70) < 0.1f);
        const std::string words = drag.by(z_ring, center + glm::vec2(90, 0), circle(0, 450));
        CHECK(std::fabs(std::fabs(std::stod(words)) - 450) < 0.1);
    }
}

TEST_CASE("below a turned parent: a move goes along the world's axis, a turn about it, and lights turn with the rest") {
    const float mirror = GENERATE(1.0f, -1.0f);
    Document document;
    const EntryId parent = add_object(document, named("parent")), child = add_object(document, named("child"), parent);
    const EntryId light =
        add_light(document, {.kind = Light::Kind::spot, .position = {0, 0, 0}, .direction = {1, 0, 0}});
    place(document, parent, {{0, 0, 0}, {20, 30, 40}, {2, 2 * mirror, 2}});
    place(document, child, {{0, 0, 0}, {50, 60, 70}, glm::vec3(1)});
    Dragged drag{document, {child}};
    const glm::mat4 before = world_of(document, child);
    drag.by(x_axis, center + glm::vec2(45, 0), {center + glm::vec2(95, 0)});
    glm::vec3 moved = glm::vec3(world_of(document, child)[3]);
    CHECK(moved.x > 0.5f);
    CHECK(std::fabs(moved.y) + std::fabs(moved.z) < 1e-5f);
    document.undo();
    drag.ids = {child, light};
    drag.tool = Tool::rotate;
    drag.by(z_ring, center + glm::vec2(90, 0), circle(0, -90));
    const glm::mat4 turned = glm::rotate(glm::mat4(1), glm::radians(90.0f), {0, 0, 1}) * before;
    const glm::mat4 after = world_of(document, child);
    for (int c = 0; c < 3; ++c) CHECK(glm::length(after[c] - turned[c]) < 1e-4f);
    CHECK(glm::length(document.at(light).light()->direction - glm::vec3(0, 1, 0)) < 1e-4f);
}

TEST_CASE("scaling: two go apart from their middle, one stays where it is; never 0, and beyond it mirrored") {
    Document document;
    const std::vector<EntryId> ids = add_all(document, {"a", "b"});
    place(document, ids[0], {{-1, 0, 0}, {}, glm::vec3(1)});
    place(document, ids[1], {{1, 0, 0}, {}, glm::vec3(1)});
    Dragged drag{document, ids, view_from({0, 0, 10}), Tool::scale};
    drag.by(whole, center, {center + glm::vec2(50, 0)});  // e^0.5
    for (const float side : {-1.0f, 1.0f}) {
        const SceneObject& object = *document.at(ids[side < 0 ? 0 : 1]).object();
        CHECK(std::fabs(object.position.x - side * 1.648721f) < 1e-4f);
        CHECK(std::fabs(object.scale.y - 1.648721f) < 1e-4f);
    }
    document.undo();
    drag.ids = {ids[1]};
    const glm::vec2 there = *on_screen(drag.view, {1, 0, 0});
    drag.by(whole, there, {there + glm::vec2(50, 0)});
    CHECK(document.at(ids[1]).object()->position.x == 1);
    document.undo();
    drag.by(x_axis, there + glm::vec2(90, 0), {there + glm::vec2(-90, 0)});
    CHECK(std::fabs(document.at(ids[1]).object()->scale.x + 1) < 0.1f);
    document.undo();
    drag.tool = Tool::scale;
    drag.by(x_axis, there + glm::vec2(90, 0), {there + glm::vec2(-90, 0), there}, true);
    CHECK(std::fabs(document.at(ids[1]).object()->scale.x) == least_scale);
}

TEST_CASE(
    "handles: the middle of many, axes of the active one, planes filled and not from their edge, none from its end") {
    Document document;
    const std::vector<EntryId> ids = add_all(document, {"a", "b"});
    place(document, ids[0], {{2, 0, 0}, {}, glm::vec3(1)});
    place(document, ids[1], {{-4, 0, 0}, {0, 0, 90}, glm::vec3(1)});
    Selection selection;
    selection.set(ids);
    const View view = view_from({0, 0, 10});
    const auto in_world = *gizmo_place(document, selection, view, Tool::move, false),
               in_local = *gizmo_place(document, selection, view, Tool::move, true),
               scaled = *gizmo_place(document, selection, view, Tool::scale, false);
    CHECK(glm::length(in_world.pivot - glm::vec3(-1, 0, 0)) < 1e-5f);
    CHECK(in_world.axes == glm::mat3(1));
    CHECK(glm::length(in_local.axes[0] - glm::vec3(0, 1, 0)) < 1e-5f);
    CHECK(glm::length(scaled.axes[0] - glm::vec3(0, 1, 0)) < 1e-5f);
    const glm::vec2 pivot = *on_screen(view, in_world.pivot);
    CHECK(handle_at(in_world, view, pivot + glm::vec2(26, -26)) == Handle{Handle::Kind::plane, 2});
    CHECK(handle_at(in_world, view, pivot + glm::vec2(-5, 5)) == whole);
    CHECK(handle_at(in_world, view, pivot + glm::vec2(60, 5)) == x_axis);
    CHECK_FALSE(handle_at(in_world, view, pivot + glm::vec2(60, 12)));
    CHECK_FALSE(handle_at(in_world, view, pivot + glm::vec2(130, 0)));
    // On a screen of twice the dots all of it is twice as large: length, width and reach.
    const auto large = *gizmo_place(document, selection, view, Tool::move, false, 2.0f);
    CHECK(handle_at(large, view, pivot + glm::vec2(130, 12)) == x_axis);
    CHECK_FALSE(handle_at(large, view, pivot + glm::vec2(200, 0)));
    const View side = view_from({0, 10, 10});
    CHECK(is_end_on(in_world, {Handle::Kind::plane, 1}, view_from({9, 0, 0}, {-1, 0, 0})));
    CHECK_FALSE(is_end_on(in_world, {Handle::Kind::plane, 1}, side));
    // Looking along z, only the handles across it can be grabbed.
    const View from_end = view_from({-1, 0, 10}, {-1, 0, 0});
    CHECK(handle_at(in_world, from_end, center + glm::vec2(0, 5)) == whole);
    const View nearly = view_from(in_world.pivot + glm::vec3(0.86f, 0.86f, 9.9f), in_world.pivot);
    CHECK_FALSE(handle_at(in_world, nearly, center + glm::vec2(-12, 12)));  // its tip is 11 pixels from the middle
    CHECK_FALSE(on_screen(view, {0, 0, 11}));
    // At the edge of a wide picture an arrow is as long as in its middle: depth counts, not distance.
    place(document, ids[0], {{6, 0, 0}, {}, glm::vec3(1)});
    selection.set({ids[0]});
    const auto at_edge = *gizmo_place(document, selection, view, Tool::move, false);
    const float length = glm::length(*on_screen(view, at_edge.pivot + at_edge.length_m * at_edge.axes[1]) -
                                     *on_screen(view, at_edge.pivot));
    CHECK(std::fabs(length - 90) < 0.5f);
}

TEST_CASE("handles are as large as GizmoSizes says, and within 8 degrees of their end or edge they are gone") {
    Document document;
    const std::vector<EntryId> ids = add_all(document, {"a"});
    Selection selection;
    selection.set(ids);
    const View front = view_from({0, 0, 10});
    const auto at = [&](Tool tool, double from_middle_px, double direction_deg, float scale = 1) {
        const double rad = glm::radians(direction_deg);
        const glm::vec2 cursor = center + float(from_middle_px) * glm::vec2(std::cos(rad), -std::sin(rad));
        return handle_at(*gizmo_place(document, selection, front, tool, false, scale), front, cursor);
    };
    // Arrows of 90 pixels, squares of 28 that begin 12 from the middle, a disc of 9; 7 pixels reach each of them.
    for (const float scale : {1.0f, 2.0f}) {
        const double px = double(scale);
        CHECK(at(Tool::move, 95 * px, 0, scale) == x_axis);
        CHECK_FALSE(at(Tool::move, 99 * px, 0, scale));
        CHECK(at(Tool::move, 15 * px, 200, scale) == whole);
        CHECK_FALSE(at(Tool::move, 17.5 * px, 200, scale));
        CHECK(at(Tool::move, (40 * std::sqrt(2) + 6) * px, 45, scale) == Handle{Handle::Kind::plane, 2});
        CHECK_FALSE(at(Tool::move, (40 * std::sqrt(2) + 8) * px, 45, scale));
        CHECK(at(Tool::rotate, 90 * px, 40, scale) == z_ring);
        CHECK(at(Tool::rotate, 84 * px, 40, scale) == z_ring);
        CHECK_FALSE(at(Tool::rotate, 82 * px, 40, scale));
        CHECK(at(Tool::rotate, 103.5 * px, 40, scale) == whole);
        CHECK_FALSE(at(Tool::rotate, 112 * px, 40, scale));
    }
    const GizmoPlace place = *gizmo_place(document, selection, front, Tool::move, false);
    for (const double degrees : {7.5, 8.5}) {
        const double rad = glm::radians(degrees);
        const View from_end = view_from(10.0f * glm::vec3(std::sin(rad), 0, std::cos(rad)));
        CHECK(is_end_on(place, {Handle::Kind::axis, 2}, from_end) == (degrees < 8));
        CHECK(is_end_on(place, {Handle::Kind::plane, 0}, from_end) == (degrees < 8));
        CHECK_FALSE(is_end_on(place, {Handle::Kind::axis, 0}, from_end));
        CHECK_FALSE(is_end_on(place, {Handle::Kind::plane, 2}, from_end));
    }
}

TEST_CASE("nothing beside or behind the camera is on the screen, and a gizmo there has the size that it has nearest") {
    const View view = view_from({0, 0, 10});
    for (const glm::vec3& gone : {glm::vec3(0, 0, 10), glm::vec3(1, 0, 10), glm::vec3(0, 3, 10), glm::vec3(0, 0, 10.1f),
                                  glm::vec3(0.1f, 0.1f, 30)})
        CHECK_FALSE(on_screen(view, gone));
    REQUIRE(on_screen(view, {0.01f, 0, 9.9f}));
    // What stands 0.1 m before a camera of a width of 960 and a height of 540 pixels.
    const double pixels = 270 / std::tan(0.5 * double(view.camera.fov_y_rad));
    CHECK(double(on_screen(view, {0.01f, 0, 9.9f})->x) == Approx(480 + 0.1 * pixels).margin(0.05));
    Document document;
    const std::vector<EntryId> ids = add_all(document, {"a"});
    Selection selection;
    selection.set(ids);
    for (const float z : {10.0f, 10.5f, 300.0f}) {
        place(document, ids[0], {{0, 0, z}, {}, glm::vec3(1)});
        const GizmoPlace there = *gizmo_place(document, selection, view, Tool::move, false);
        CHECK(double(there.length_m) == Approx(90 * double(view.camera.near_m) / pixels).epsilon(0.01));
        CHECK_FALSE(handle_at(there, view, center + glm::vec2(60, 0)));
        CHECK_FALSE(handle_at(there, view, center));
    }
}

TEST_CASE("dragged in a plane up to its horizon and beyond, nothing goes further than a hundred arrows") {
    Document document;
    const std::vector<EntryId> ids = add_all(document, {"a"});
    const Dragged drag{document, ids, view_from({0, 5, 10}, {0, 5, 0})};
    const glm::vec2 start = *on_screen(drag.view, glm::vec3(0.0f));
    for (const float y : {268.0f, 269.9f, 270.0f, 270.1f, 272.0f, 10.0f}) {
        drag.by({Handle::Kind::plane, 1}, start, {{500, y}});
        const glm::vec3 at = document.at(ids[0]).object()->position;
        CHECK(std::isfinite(at.x + at.y + at.z));
        CHECK(glm::length(at) < 200);
        document.undo();
    }
}

TEST_CASE("rays: flat boxes, boxes behind, along a face; corners of triangles, and nothing behind the eye") {
    const PickRay down{{0.3f, 5, 0.3f}, {0, -1, 0}};
    CHECK(hit_box(down, {{0, 1, 0}, {1, 1, 1}}) == 4.0f);
    CHECK_FALSE(hit_box(down, {{2, 0, 0}, {3, 1, 1}}));
    CHECK_FALSE(hit_box(down, {{0, 6, 0}, {1, 7, 1}}));
    CHECK(hit_box(down, {{0, 4, 0}, {1, 7, 1}}) == 0.0f);
    CHECK_FALSE(hit_box(down, Bounds{}));
    // A flat box aimed at its edge, where two faces are entered at one distance. In double precision half of the rays hit it.
    Random random(3);
    int missed = 0, hits = 0;
    for (int i = 0; i < 20000; ++i) {
        const glm::vec3 origin(random.uniform(-9, 9), random.uniform(1, 9), random.uniform(-9, 9));
        const float height = float(random.uniform(-1, 0.5));
        const glm::vec3 to(i % 2 ? -1 : 1, height, random.uniform(-1, 1)), direction = glm::normalize(to - origin);
        const glm::dvec3 near = (glm::dvec3(-1, height, -1) - glm::dvec3(origin)) / glm::dvec3(direction);
        const glm::dvec3 far = (glm::dvec3(1, height, 1) - glm::dvec3(origin)) / glm::dvec3(direction);
        const glm::dvec3 enter = glm::min(near, far), leave = glm::max(near, far);
        if (std::max({enter.x, enter.y, enter.z}) > std::min({leave.x, leave.y, leave.z})) continue;
        ++hits;
        missed += !hit_box({origin, direction}, {{-1, height, -1}, {1, height, 1}});
    }
    CHECK(hits > 5000);
    CHECK(missed == 0);
    const glm::vec3 a(0, 0, 0), b(1, 0, 0), c(0, 0, 1);
    CHECK(hit_triangle({0.3, 2, 0.3}, {0, -1, 0}, a, b, c) == 2.0);
    CHECK_FALSE(hit_triangle({0.6, 2, 0.6}, {0, -1, 0}, a, b, c));
    CHECK_FALSE(hit_triangle({0.3, -2, 0.3}, {0, -1, 0}, a, b, c));
    CHECK_FALSE(hit_triangle({0.3, 2, 0.3}, {1, 0, 0}, a, b, c));
    CHECK_FALSE(hit_triangle({-0.1, 2, 0.3}, {0, -1, 0}, a, b, c));
    CHECK_FALSE(hit_triangle({0.3, 2, -0.1}, {0, -1, 0}, a, b, c));
}
