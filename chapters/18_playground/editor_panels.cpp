// The editor's panels: where each of them stands.
#include <algorithm>
#include <array>

#include "18_playground/editor_part.h"
#include "18_playground/editor_window.h"
#include "18_playground/widgets.h"
#include "common/base/error.h"

namespace lightwalk {
namespace {

// A view goes along with edits of the scene's own camera, and with their undo: else they would be lost when it is saved.
bool follow(Camera& view, const Camera& before, const Camera& now) {
    const bool moves = now.position != before.position || now.target != before.target || now.up != before.up;
    if (moves) {
        view.position = now.position;
        view.target = now.target;
        view.up = now.up;
    }
    bool changes = moves;
    for (float Camera::*const lens : {&Camera::fov_y_rad, &Camera::near_m, &Camera::far_m})
        if (now.*lens != before.*lens) {
            view.*lens = now.*lens;
            changes = true;
        }
    return changes;
}

}  // namespace

bool EditorWindow::draw_panels(const Area& picture, float dock_px, float scale) {
    view_.picture = picture;
    view_.automatic = automatic;
    const bool changed = std::exchange(view_.changed, false);
    const uint64_t state = editor.document.state();
    const std::vector<EntryId> selected = editor.selection.ids;
    const auto handles = std::pair(editor.tool, editor.local);
    if (dock_px == 0.0f || shows_list()) {
        tree_.give_up_fields();
        properties_.wants_keyboard = false;
    }
    editor.scale = scale;
    output_frame.draw(picture, scale);
    if (dock_px > 0.0f) {
        draw_dock(dock_px, scale);
        tour_.draw(dock_px, scale);
    }
    take_dropped();
    files_.draw_question();
    const Camera& own = editor.document.settings().camera;
    view_.changed |= follow(camera, own_camera_.value_or(own), own);
    own_camera_ = own;
    carry_on_previews();
    return changed || state != editor.document.state() || selected != editor.selection.ids ||
           handles != std::pair(editor.tool, editor.local) || editor.document.in_step();
}

void EditorWindow::draw_dock(float width_px, float scale) {
    ImGui::SetNextWindowPos({0.0f, 0.0f});
    ImGui::SetNextWindowSize({width_px, ImGui::GetIO().DisplaySize.y - tour_.height_px(scale)});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0.0f);
    ImGui::Begin("editor", nullptr,
                 ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoBringToFrontOnFocus);
    ImGui::PopStyleVar();
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {6.0f * scale, 3.0f * scale});  // four buttons side by side
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {5.0f * scale, 5.0f * scale});
    draw_toolbar();
    draw_lights_toolbar();
    ImGui::PopStyleVar(2);
    loading_.draw();
    if (browser_.shown) {
        browser_.draw(scale);
    } else if (steps_.shown) {
        steps_.draw();
    } else if (keys_.shown) {
        keys_.draw();
    } else {
        tree_.draw();
        properties_.draw();
    }
    ImGui::End();
}

void EditorWindow::draw_toolbar() {
    const auto files =
        tool_row({{"open", with_icon(icon::folder, "open"), "Ctrl+O: files, to add or to open", browser_.shown},
                  {"undo", icon_or(icon::undo, "undo"), "Ctrl+Z: undo"},
                  {"redo", icon_or(icon::redo, "redo"), "Ctrl+Y: redo"},
                  {"steps", with_icon(icon::list, "steps"),
                   "F4: all steps by name; a click goes back or forward to one", steps_.shown},
                  {"?", icon_or(icon::help, "?"), "F1: all keys", keys_.shown}});
    if (files == 0) show_list(browser_.shown, !browser_.shown);
    if (files == 1) editor.undo(*this);
    if (files == 2) editor.redo(*this);
    if (files == 3) show_list(steps_.shown, !steps_.shown);
    if (files == 4) show_list(keys_.shown, !keys_.shown);
    const auto tool =
        tool_row({{"move", with_icon(icon::move, "move"), "1: move along axes and planes; with Shift in steps",
                   editor.tool == Tool::move},
                  {"turn", with_icon(icon::turn, "turn"), "2: rotate; with Shift by 15°", editor.tool == Tool::rotate},
                  {"size", with_icon(icon::scale, "size"), "3: scale", editor.tool == Tool::scale},
                  {editor.local ? "local" : "world",
                   with_icon(editor.local ? icon::object : icon::world, editor.local ? "local" : "world"),
                   "L: axes of the world or of the object"}});
    if (tool == 3) editor.local = !editor.local;
    if (tool && *tool < 3) editor.tool = std::array{Tool::move, Tool::rotate, Tool::scale}[*tool];
}

void EditorWindow::draw_lights_toolbar() {
    const auto kind = tool_row({{"sun", with_icon(icon::sun, "sun"), "Shift+1: add a light that is far away"},
                                {"lamp", with_icon(icon::lamp, "lamp"), "Shift+2: add a light that shines all around"},
                                {"spot", with_icon(icon::spot, "spot"), "Shift+3: add a light that shines in a cone"}});
    if (kind) add_light(static_cast<Light::Kind>(*kind));
    if (tool_button("scatter", "Point and spot lights over the scene, as many as the number says", false,
                    with_icon(icon::scatter, "scatter")))
        scatter_lights();
    ImGui::SameLine();
    ImGui::SetNextItemWidth(-1.0f);
    ImGui::DragInt("##scatter", &scatter_count_, 10.0f, 1, 100000, "%d lights");
    scatter_count_ = std::clamp(scatter_count_, 1, 100000);
    log_place("number.scatter");
    help_on_hover("Number of lights that are scattered, up to 100,000");
}

void EditorWindow::scatter_lights() {
    editor.selection.set(scatter(editor.document, scene.bounds, scatter_count_, unsigned(editor.document.size())));
}

void EditorWindow::add_light(Light::Kind kind) {
    const Landing landing = landing_on(scene, camera, placing_ray(view_), view_.terrain());
    editor.add_light(placed_light(kind, landing, scene, view_now));
}

// An image becomes the diffuse map of what is selected, or light from all around where it has a wide range.
void EditorWindow::choose_file(const std::filesystem::path& file, bool adds) {
    if (is_height_map_file(file) && !is_image(file))
        settings_.put_terrain(asset_name(file).string());
    else if (is_hdr_name(file))
        settings_.put_environment(asset_name(file).string());
    else if (is_image(file))
        properties_.set_map(editor.selection.ids, "diffuse", asset_name(file).string());
    else
        loading_.want(file, adds);
}

// A model is placed where it was dropped; an image goes to the object there.
void EditorWindow::take_dropped() {
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const glm::vec2 pixel = glm::vec2(mouse.x, mouse.y) - glm::vec2(view_.picture.corner);
    const bool over = glm::all(glm::greaterThanEqual(pixel, glm::vec2(0.0f))) &&
                      glm::all(glm::lessThan(pixel, glm::vec2(view_.picture.size)));
    const auto file = over ? browser_.dropped() : std::nullopt;
    if (!file) return;
    view_.pointer = pixel;
    if (is_image(*file) && !is_hdr_name(*file)) {
        const auto hit = pick_triangle(scene, placing_ray(view_));
        editor.select_item(scene, hit ? std::optional(hit->item) : std::nullopt, false);
    }
    choose_file(*file, file->extension() != ".json");
}

void EditorWindow::carry_on_previews() {
    if (!view_.gpu) return;
    try {
        if (properties_.ball.is_due())
            properties_.ball.make();
        else if (browser_.shown && browser_.thumbnails.carry_on(*view_.gpu, properties_.ball.preview))
            view_.changed = true;
    } catch (const InputError& e) { editor.notice = e.what(); }
}

}  // namespace lightwalk
