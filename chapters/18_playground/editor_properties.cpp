// What is selected, as numbers, colours and files.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "18_playground/editor_window.h"
#include "18_playground/widgets.h"
#include "common/base/error.h"
#include "common/base/files.h"

namespace lightwalk {
namespace {

constexpr float label_px = 110.0f, short_label_px = 70.0f, color_label_px = 80.0f;

}  // namespace

// What is typed has no range of its own: 1e39 is infinite, and 0 times that is no number.
bool EditorWindow::takes(const char* label, float* values, int count, const float* before, float lower, float upper) {
    for (int i = 0; i < count; ++i)
        if (!(values[i] >= lower && values[i] <= upper)) {
            refuse(fmt::format("{}: {:g} is out of range, {:g} to {:g}", label, values[i], lower, upper));
            return std::copy(before, before + count, values), false;
        }
    return true;
}

bool EditorWindow::numbers(const char* label, const char* help, glm::vec3& value, float speed) {
    ImGui::SetNextItemWidth(-short_label_px);
    const glm::vec3 before = value;
    const bool changed = ImGui::DragFloat3(label, &value.x, speed, 0.0f, 0.0f, "%.5g");
    log_place(std::string("numbers.") + label);
    help_on_hover(help);
    return changed && takes(label, &value.x, 3, &before.x, -1e9f, 1e9f);
}

bool EditorWindow::number(const char* label, const char* help, float& value, float speed, float lower, float upper) {
    ImGui::SetNextItemWidth(-label_px);
    const float before = value;
    const bool changed = ImGui::DragFloat(label, &value, speed, lower, upper, "%.5g");
    log_place(std::string("number.") + label);
    help_on_hover(help);
    return changed && takes(label, &value, 1, &before, lower, upper);
}

// Dear ImGui writes three decimals of each, which are cut here.
bool EditorWindow::color(const char* label, const char* help, glm::vec3& value, float most) {
    ImGui::PushID(label);
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
    const glm::vec3 before = value;
    ImGui::SetNextItemWidth(-color_label_px - ImGui::GetFrameHeight() - gap);
    bool changed = ImGui::DragFloat3("##numbers", &value.x, 0.01f, 0.0f, most, "%.3g");
    log_place(std::string("color.") + label);
    help_on_hover(help);
    ImGui::SameLine(0.0f, gap);
    changed |= ImGui::ColorEdit3(label, &value.x, ImGuiColorEditFlags_Float | ImGuiColorEditFlags_NoInputs);
    ImGui::PopID();
    return changed && takes(label, &value.x, 3, &before.x, 0.0f, most);
}

template <class Change>
void EditorWindow::change(EntryId id, const char* what, const Change& set) {
    if (is_locked(editor.document, id)) {
        editor.notice = "it is locked";
        return;
    }
    editor.document.begin(what, editor.gesture);
    set(editor.document.edit(id));
    if (const Said said = cannot_be_saved(editor.document.at(id), editor.store.path); !said.empty()) {
        editor.document.cancel();
        return refuse(said);
    }
    editor.document.commit();
}

void EditorWindow::draw_properties() {
    if (!ImGui::IsAnyItemActive()) refused_.clear();
    ImGui::Separator();
    const EntryId id = editor.selection.active();
    if (id == no_entry || !editor.document.find(id)) {
        types_ = false;
        ImGui::TextColored(quiet_color, "nothing is selected");
        return;
    }
    begin_padded_child("properties", {0.0f, 0.0f});
    ImGui::PushID(static_cast<int>(id));  // what is being typed belongs to this entry alone
    if (id == root_entry) {
        types_ = false;
        draw_settings();
    } else {
        const Entry& entry = editor.document.at(id);
        ImGui::Text("%s", shown_name(entry).c_str());
        if (editor.selection.ids.size() > 1) {
            ImGui::SameLine();
            ImGui::TextColored(quiet_color, "and %zu more", editor.selection.ids.size() - 1);
        }
        bool hidden = entry.hidden, locked = entry.locked;
        if (ImGui::Checkbox("hidden", &hidden)) set_hidden(editor.document, editor.selection.ids, hidden);
        log_place("check.hidden");
        ImGui::SameLine();
        if (ImGui::Checkbox("locked", &locked)) set_locked(editor.document, editor.selection.ids, locked);
        ImGui::SameLine();
        if (tool_button("rename", "Also by a double click in the tree")) begin_renaming(id);
        if (editor.document.at(id).object())
            draw_object(id);
        else
            draw_light(id);
    }
    ImGui::PopID();
    ImGui::EndChild();
}

void EditorWindow::draw_object(EntryId id) {
    Placement own = placement_of(*editor.document.at(id).object());
    const float size = std::max(glm::length(scene.bounds.empty() ? glm::vec3(1.0f) : scene.bounds.extent()), 1e-3f);
    if (std::exchange(types_, false)) ImGui::SetKeyboardFocusHere();
    bool moved = numbers("position", "Position in the parent's space, in metres", own.position, 0.001f * size);
    moved |= numbers("rotation", "Rotation about x, then y, then z, in degrees", own.rotation_deg, 0.5f);
    moved |= numbers("scale", "Scale along the object's own axes; negative: mirrored", own.scale, 0.01f);
    if (moved) refuse(place(editor.document, id, own, editor.gesture));
    if (!editor.document.at(id).object()->model.empty()) draw_material(id);
}

void EditorWindow::draw_material(EntryId id) {
    const bool open = ImGui::CollapsingHeader("Material");
    log_place("section.Material");
    if (!open) return;
    MaterialOverride material = editor.document.at(id).object()->material;
    glm::vec3 diffuse(0.8f), specular(0.0f), emissive(0.0f);
    float shininess = 32.0f, opacity = 1.0f;
    for (const DrawItem& item : scene.items)
        if (editor.live.entry_of(item.object) == id) {
            draw_ball(id, item);
            diffuse = item.material.diffuse, specular = item.material.specular, emissive = item.material.emissive;
            shininess = item.material.shininess, opacity = item.material.opacity;
            break;
        }
    float roughness = material.roughness.value_or(0.5f), metalness = material.metalness.value_or(0.0f);
    bool changed = false;
    if (color("diffuse", "Diffuse colour: the share of light that is scattered, linear", diffuse, 1.0f))
        material.diffuse = diffuse, changed = true;
    if (color("specular", "Specular colour: the share that is reflected, linear", specular, 1.0f))
        material.specular = specular, changed = true;
    if (color("emissive", "Emitted radiance, in the unit of the scene's light", emissive, 1e4f))
        material.emissive = emissive, changed = true;
    if (number("shininess", "Exponent of the highlight; a larger one is sharper", shininess, 1.0f, 0.0f, 1e5f))
        material.shininess = shininess, changed = true;
    if (number("roughness", "Roughness: 0 is a mirror, 1 is dull", roughness, 0.01f, 0.0f, 1.0f))
        material.roughness = roughness, changed = true;
    if (number("metalness", "Metalness: 0 is an insulator, 1 is a metal", metalness, 0.01f, 0.0f, 1.0f))
        material.metalness = metalness, changed = true;
    if (number("opacity", "Opacity: 0 is invisible, 1 is opaque", opacity, 0.01f, 0.0f, 1.0f))
        material.opacity = opacity, changed = true;
    for (const MapSlotInfo& slot : map_slots()) {
        const std::string& key = slot.name;
        const auto given = material.maps.find(key);
        std::string file = given == material.maps.end() ? "" : given->second.string();
        ImGui::SetNextItemWidth(-label_px);
        if (!text_field((key + " map").c_str(), file, "none") ||
            (given == material.maps.end() ? file.empty() : file == given->second))
            continue;
        try {
            if (!file.empty()) find_asset(file);
            if (file.empty())
                material.maps.erase(key);
            else
                material.maps[key] = file;
            changed = true;
        } catch (const InputError& e) { editor.notice = e.what(); }
    }
    if (changed) change(id, "material", [&](Entry& entry) { entry.object()->material = material; });
}

void EditorWindow::draw_light(EntryId id) {
    Light own = *editor.document.at(id).light();
    bool changed = false;
    int kind = static_cast<int>(own.kind);
    ImGui::SetNextItemWidth(-label_px);
    if (ImGui::Combo("type", &kind, "directional\0point\0spot\0"))
        own.kind = static_cast<Light::Kind>(kind), changed = true;
    changed |= color("color", "Colour of the light, linear", own.color, 1.0f);
    changed |= number("intensity", "Intensity: the factor of the colour", own.intensity,
                      0.02f * std::max(own.intensity, 0.1f), 0.0f, 1e6f);
    if (own.kind != Light::Kind::point) {
        if (std::exchange(types_, false)) ImGui::SetKeyboardFocusHere();
        glm::vec3 direction = own.direction;
        if (numbers("direction", "Direction in which the light travels", direction, 0.01f) &&
            glm::length(direction) > 1e-6f)
            own.direction = glm::normalize(direction), changed = true;
    }
    if (own.kind == Light::Kind::directional) {
        float size = glm::degrees(own.size_rad);
        if (number("lamp size", "Angle that the lamp subtends, in degrees (the sun: 0.53); it softens shadows", size,
                   0.01f, 0.0f, 90.0f))
            own.size_rad = glm::radians(size), changed = true;
    } else {
        if (std::exchange(types_, false)) ImGui::SetKeyboardFocusHere();
        changed |= numbers("position", "Position in the world, in metres", own.position, 0.01f);
        changed |= number("range", "Distance at which the light ends, in metres", own.range_m, 0.05f, 0.0f, 1e6f);
        changed |=
            number("lamp size", "Diameter of the lamp, in metres; it softens shadows", own.size_m, 0.005f, 0.0f, 1e3f);
    }
    if (own.kind == Light::Kind::spot) {
        float inner = glm::degrees(own.inner_rad), outer = glm::degrees(own.outer_rad);
        if (number("inner angle", "Half angle of the cone with the full intensity, in degrees", inner, 0.2f, 0.0f,
                   180.0f))
            own.inner_rad = glm::radians(inner), changed = true;
        if (number("outer angle", "Half angle of the whole cone, in degrees", outer, 0.2f, 0.0f, 180.0f))
            own.outer_rad = glm::radians(outer), changed = true;
        own.inner_rad = std::min(own.inner_rad, own.outer_rad);
        changed |= number("softness", "Softness of the cone's edge", own.softness, 0.01f, 0.0f, 1.0f);
    }
    changed |= ImGui::Checkbox("shadow", &own.shadow);
    help_on_hover("Whether the light casts shadows");
    if (changed) change(id, "light", [&](Entry& entry) { *entry.light() = own; });
}

// It is drawn when nobody drags: a new material means its textures' levels again.
void EditorWindow::draw_ball(EntryId id, const DrawItem& item) {
    SceneFile shows = material_ball(*editor.document.at(id).object(), item);
    if (std::string key = scene_text(shows); key != ball_key_ && !ImGui::IsMouseDown(ImGuiMouseButton_Left))
        ball_key_ = std::move(key), ball_scene_ = std::move(shows);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float pixel = std::max(1.0f, std::floor(ImGui::GetFontSize() / 15.0f));
    if (ball_.width) draw_pixels(ball_, at, pixel);
    ImGui::Dummy({pixel * float(ball_size), pixel * float(ball_size)});
    log_place("ball");
}

void EditorWindow::carry_on_previews() {
    if (!gpu_) return;
    if (ball_scene_) try {
            ball_ = preview_.draw(*gpu_, *std::exchange(ball_scene_, std::nullopt), glm::uvec2(ball_size));
            log_event("ball drawn");
            changed_ = true;
        } catch (const InputError& e) { editor.notice = e.what(); }
    else if (browser_.shown && browser_.thumbnails.carry_on(*gpu_, preview_))
        changed_ = true;
}

void EditorWindow::draw_settings() {
    if (!facet_.empty()) ImGui::TextUnformatted(facet_.c_str());
    if (facet_ == "environment" || facet_ == "camera") return draw_facet_settings();
    if (!facet_.empty()) return draw_facet();
    ImGui::TextUnformatted(editor.store.path.empty() ? "not saved yet" : editor.store.path.filename().c_str());
    SceneSettings settings = editor.document.settings();
    bool changed = color("ambient", "Light from all sides where there is no environment", settings.ambient, 1e4f);
    changed |= color("background", "Colour where nothing is drawn, linear", settings.background, 1e4f);
    ImGui::SetNextItemWidth(-color_label_px);
    text_field("##save as", save_name_, "scene.json");
    ImGui::SameLine();
    if (tool_button("save as", "Ctrl+Shift+S: saves to this file, which is edited from then on")) save_as();
    if (changed) change(root_entry, "scene", [&](Entry& entry) { *entry.settings() = settings; });
}

// What a facet has beside knobs.
void EditorWindow::draw_facet_settings() {
    SceneSettings settings = editor.document.settings();
    bool changed = false;
    if (facet_ == "camera") {
        if (tool_button("take this view", "The scene's own camera becomes the one that is shown"))
            settings.camera = camera, changed = true;
        ImGui::SameLine();
        if (tool_button("go there", "The view becomes the scene's own")) camera = settings.camera, changed_ = true;
        Camera& own = settings.camera;
        changed |= numbers("position", "Position of the camera, in metres", own.position, 0.01f);
        changed |= numbers("target", "Point in the middle of the picture, in metres", own.target, 0.01f);
        float degrees = glm::degrees(own.fov_y_rad);
        if (number("field of view", "Vertical field of view, in degrees", degrees, 0.2f, 1.0f, 170.0f))
            own.fov_y_rad = glm::radians(degrees), changed = true;
        changed |= number("near", "Distance of the near plane, in metres", own.near_m, 0.001f, 1e-5f, 1e5f);
        changed |= number("far", "Distance of the far plane, in metres", own.far_m, 1.0f, 1e-4f, 1e9f);
    } else {
        std::string image = settings.environment.image.string();
        ImGui::SetNextItemWidth(-short_label_px);
        if (text_field("image", image, "none") && image != settings.environment.image) try {
                if (!image.empty()) find_asset(image);
                settings.environment.image = image, settings.environment.where = "environment", changed = true;
            } catch (const InputError& e) { editor.notice = e.what(); }
        changed |=
            number("brightness", "Factor of the image's light", settings.environment.intensity, 0.01f, 0.0f, 1e6f);
        changed |= number("turn", "Rotation about the vertical, in degrees", settings.environment.rotation_deg, 0.5f,
                          -360.0f, 360.0f);
    }
    if (changed) change(root_entry, facet_.c_str(), [&](Entry& entry) { *entry.settings() = settings; });
    draw_facet();
}

}  // namespace lightwalk
