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

// True where a number was changed; `begins` counts gestures up, so that a drag is one step.
bool numbers(const char* label, glm::vec3& value, float speed) {
    ImGui::SetNextItemWidth(-70.0f);
    const glm::vec3 before = value;
    const bool changed = ImGui::DragFloat3(label, &value.x, speed, 0.0f, 0.0f, "%.5g");
    log_place(std::string("numbers.") + label);
    if (std::isfinite(value.x + value.y + value.z)) return changed;
    value = before;  // 1e39 was typed
    return false;
}

bool number(const char* label, float& value, float speed, float lower, float upper) {
    ImGui::SetNextItemWidth(-110.0f);
    const bool changed = ImGui::DragFloat(label, &value, speed, lower, upper, "%.5g");
    log_place(std::string("number.") + label);
    if (changed) value = std::clamp(value, lower, upper);  // what is typed has no range of its own
    return changed;
}

bool color(const char* label, glm::vec3& value) {
    ImGui::SetNextItemWidth(-110.0f);
    const bool changed = ImGui::ColorEdit3(label, &value.x, ImGuiColorEditFlags_Float);
    log_place(std::string("color.") + label);
    return changed;
}

}  // namespace

template <class Change>
void EditorWindow::change(EntryId id, const char* what, const Change& set) {
    if (is_locked(editor.document, id)) {
        editor.notice = "it is locked";
        return;
    }
    editor.document.begin(what, editor.gesture);
    set(editor.document.edit(id));
    editor.document.commit();
}

void EditorWindow::draw_properties() {
    ImGui::Separator();
    const EntryId id = editor.selection.active();
    if (id == no_entry || !editor.document.find(id)) {
        ImGui::TextColored(quiet_color, "nothing is selected");
        return;
    }
    begin_padded_child("properties", {0.0f, 0.0f});
    ImGui::PushID(static_cast<int>(id));  // what is being typed belongs to this entry alone
    if (id == root_entry) {
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
    bool moved = numbers("position", own.position, 0.001f * size);
    moved |= numbers("rotation", own.rotation_deg, 0.5f);
    moved |= numbers("scale", own.scale, 0.01f);
    if (moved) say(place(editor.document, id, own, editor.gesture));
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
    if (color("diffuse", diffuse)) material.diffuse = glm::clamp(diffuse, 0.0f, 1.0f), changed = true;
    if (color("specular", specular)) material.specular = glm::clamp(specular, 0.0f, 1.0f), changed = true;
    if (color("emissive", emissive)) material.emissive = glm::max(emissive, 0.0f), changed = true;
    if (number("shininess", shininess, 1.0f, 0.0f, 1e5f)) material.shininess = shininess, changed = true;
    if (number("roughness", roughness, 0.01f, 0.0f, 1.0f)) material.roughness = roughness, changed = true;
    if (number("metalness", metalness, 0.01f, 0.0f, 1.0f)) material.metalness = metalness, changed = true;
    if (number("opacity", opacity, 0.01f, 0.0f, 1.0f)) material.opacity = opacity, changed = true;
    for (const MapSlotInfo& slot : map_slots()) {
        const std::string& key = slot.name;
        const auto given = material.maps.find(key);
        std::string file = given == material.maps.end() ? "" : given->second.string();
        ImGui::SetNextItemWidth(-110.0f);
        if (!text_field((key + " map").c_str(), file) ||
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
    ImGui::SetNextItemWidth(-110.0f);
    if (ImGui::Combo("type", &kind, "directional\0point\0spot\0"))
        own.kind = static_cast<Light::Kind>(kind), changed = true;
    if (color("color", own.color)) own.color = glm::clamp(own.color, 0.0f, 1.0f), changed = true;
    changed |= number("intensity", own.intensity, 0.02f * std::max(own.intensity, 0.1f), 0.0f, 1e6f);
    if (own.kind != Light::Kind::point) {
        glm::vec3 direction = own.direction;
        if (numbers("direction", direction, 0.01f) && glm::length(direction) > 1e-6f)
            own.direction = glm::normalize(direction), changed = true;
    }
    if (own.kind != Light::Kind::directional) {
        changed |= numbers("position", own.position, 0.01f);
        changed |= number("range", own.range_m, 0.05f, 0.0f, 1e6f);
        changed |= number("lamp size", own.size_m, 0.005f, 0.0f, 1e3f);
    }
    if (own.kind == Light::Kind::spot) {
        float inner = glm::degrees(own.inner_rad), outer = glm::degrees(own.outer_rad);
        if (number("inner angle", inner, 0.2f, 0.0f, 180.0f)) own.inner_rad = glm::radians(inner), changed = true;
        if (number("outer angle", outer, 0.2f, 0.0f, 180.0f)) own.outer_rad = glm::radians(outer), changed = true;
        own.inner_rad = std::min(own.inner_rad, own.outer_rad);
        changed |= number("softness", own.softness, 0.01f, 0.0f, 1.0f);
    }
    changed |= ImGui::Checkbox("shadow", &own.shadow);
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
    bool changed = color("ambient", settings.ambient);
    changed |= color("background", settings.background);
    ImGui::SetNextItemWidth(-110.0f);
    text_field("save as", save_name_);
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
        changed |= numbers("position", own.position, 0.01f);
        changed |= numbers("target", own.target, 0.01f);
        float degrees = glm::degrees(own.fov_y_rad);
        if (number("field of view", degrees, 0.2f, 1.0f, 170.0f)) own.fov_y_rad = glm::radians(degrees), changed = true;
        changed |= number("near", own.near_m, 0.001f, 1e-5f, 1e5f);
        changed |= number("far", own.far_m, 1.0f, 1e-4f, 1e9f);
        if (glm::length(own.target - own.position) < 1e-6f || own.far_m <= own.near_m) changed = false;
    } else {
        std::string image = settings.environment.image.string();
        ImGui::SetNextItemWidth(-110.0f);
        if (text_field("image", image) && image != settings.environment.image) try {
                if (!image.empty()) find_asset(image);
                settings.environment.image = image, settings.environment.where = "environment", changed = true;
            } catch (const InputError& e) { editor.notice = e.what(); }
        changed |= number("brightness", settings.environment.intensity, 0.01f, 0.0f, 1e6f);
        changed |= number("turn", settings.environment.rotation_deg, 0.5f, -360.0f, 360.0f);
    }
    if (changed) change(root_entry, facet_.c_str(), [&](Entry& entry) { *entry.settings() = settings; });
    draw_facet();
}

}  // namespace lightwalk
