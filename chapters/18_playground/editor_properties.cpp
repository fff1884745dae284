// The selection as numbers, colours and files. An edit applies to all selected entries of the active one's kind.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "18_playground/commands.h"
#include "18_playground/editor_part.h"
#include "18_playground/file_browser.h"
#include "18_playground/widgets.h"
#include "common/base/error.h"
#include "common/base/files.h"
#include "common/window/knob_widgets.h"

namespace lightwalk {

namespace {

std::string map_of(const Entry& entry, const std::string& slot) {
    const auto& maps = entry.object()->material.maps;
    const auto given = maps.find(slot);
    return given == maps.end() ? std::string() : given->second.string();
}

}  // namespace

void PropertiesPanel::draw() {
    fields_.begin_frame();
    ImGui::Separator();
    const EntryId id = editor.selection.active();
    if (id == no_entry || !editor.document.find(id)) {
        wants_keyboard = false;
        ImGui::PushTextWrapPos();
        ImGui::TextColored(quiet_color, "Nothing is selected: click an object in the picture, or a name above.");
        ImGui::PopTextWrapPos();
        return;
    }
    ImGui::BeginChild("properties", {0.0f, 0.0f});
    ImGui::PushID(static_cast<int>(id));  // text being typed belongs to this entry, or to its group
    together_ = edited_together(editor.document, editor.selection);
    if (id == root_entry) {
        wants_keyboard = false;
        settings_.draw();
    } else {
        draw_switches(id);
        if (editor.document.at(id).object())
            draw_object(id);
        else
            draw_light();
    }
    ImGui::PopID();
    ImGui::EndChild();
    log_place("properties");
}

// Of all selected entries, objects and lights alike.
void PropertiesPanel::draw_switches(EntryId id) {
    const std::vector<EntryId>& ids = editor.selection.ids;
    const Entry& entry = editor.document.at(id);
    ImGui::Text("%s", shown_name(entry).c_str());
    if (together_.size() > 1) {
        ImGui::SameLine();
        ImGui::TextColored(quiet_color, "and %zu more", together_.size() - 1);
        help_on_hover("What is edited here is edited in all of them; a dash stands for values that differ");
    }
    if (const size_t others = ids.size() - together_.size())
        ImGui::TextColored(quiet_color, "not edited: %zu of another kind", others);
    const auto differs = [&](bool Entry::*which) {
        return std::any_of(ids.begin(), ids.end(), [&](EntryId one) {
            return one != root_entry && editor.document.at(one).*which != entry.*which;
        });
    };
    bool hidden = entry.hidden, locked = entry.locked;
    const bool some_hidden = differs(&Entry::hidden), some_locked = differs(&Entry::locked);
    if (fields_.check("hidden", "Neither they nor their children are drawn", hidden, some_hidden))
        set_hidden(editor.document, ids, hidden);
    ImGui::SameLine();
    if (fields_.check("locked", "Neither picked nor changed", locked, some_locked))
        set_locked(editor.document, ids, locked);
    ImGui::SameLine();
    if (tool_button("rename", "Also by a double click in the tree")) tree_.begin_renaming(id);
}

void PropertiesPanel::draw_object(EntryId id) {
    if (is_terrain(editor.document.at(id))) return ImGui::TextColored(quiet_color, "tuned under terrain, in the tree");
    const float size = std::max(glm::length(scene.bounds.empty() ? glm::vec3(1.0f) : scene.bounds.extent()), 1e-3f);
    focus_next(wants_keyboard);
    Property position = object_property("position");
    position.field.speed = 0.001f * size;
    edit(position);
    edit(object_property("rotation"));
    edit(object_property("scale"));
    if (editor.document.at(id).object()->model.empty()) return;
    draw_offers(id);
    draw_material(id);
}

void PropertiesPanel::draw_offers(EntryId id) {
    const Editor::Offered file = editor.offered(scene, id);
    for (const auto& [name, camera] : file.cameras)
        if (tool_button(("camera " + name).c_str(), "Look through this camera of the model's file")) {
            view_.chapter.camera = camera;
            view_.changed = true;
        }
    const std::string words = fmt::format("add its {} light{}", file.lights.size(), file.lights.size() == 1 ? "" : "s");
    if (!file.lights.empty() && tool_button(words.c_str(), "The lights of the model's file become lights of the scene"))
        editor.selection.set(add_lights(editor.document, words, file.lights));
}

void PropertiesPanel::draw_material(EntryId id) {
    const bool open = ImGui::CollapsingHeader("Material");
    log_place("section.Material");
    if (!open) return;
    std::vector<const DrawItem*> firsts(scene.file.objects.size());  // of each object
    for (const DrawItem& item : scene.items)
        if (item.object < firsts.size() && !firsts[item.object]) firsts[item.object] = &item;
    const auto first = [&](EntryId one) {
        const uint32_t object = editor.live.object_of(one);
        return object < firsts.size() ? firsts[object] : nullptr;
    };
    if (first(id)) ball.draw(id, *first(id));
    for (const Property& property :
         material_properties([&](EntryId one) { return first(one) ? &first(one)->material : nullptr; }))
        edit(property);
    ImGui::TextColored(quiet_color, "maps");
    log_place("module.maps");
    for (const MapSlotInfo& slot : map_slots()) edit_map(slot.name);
}

// An empty field is a map that the model has, or none; where several differ it is empty too, and "none" clears all.
void PropertiesPanel::edit_map(const std::string& slot) {
    std::vector<EntryId> ids;
    for (const EntryId one : together_)
        if (!editor.document.at(one).object()->model.empty()) ids.push_back(one);
    const std::string before = map_of(editor.document.at(ids.back()), slot);
    const bool mixed = std::any_of(ids.begin(), ids.end(),
                                   [&](EntryId one) { return map_of(editor.document.at(one), slot) != before; });
    std::string file = mixed ? "" : before;
    label_left(slot.c_str());
    ImGui::SetNextItemWidth(-beside_px());
    const bool typed = text_field(("##" + slot + " map").c_str(), file, mixed ? "— (none clears)" : "none");
    const std::vector<EntryId> all = together_;
    pick_button(view_, slot + " map", [this, all, slot](const std::string& chosen) { set_map(all, slot, chosen); });
    if (!typed || (mixed ? file.empty() : file == before)) return;
    set_map(together_, slot, file == "none" ? "" : file);
}

void PropertiesPanel::set_map(std::vector<EntryId> ids, const std::string& slot, const std::string& file) {
    std::erase_if(ids, [&](EntryId one) {
        const Entry* const entry = editor.document.find(one);
        return !entry || !entry->object() || entry->object()->model.empty() || map_of(*entry, slot) == file;
    });
    try {
        if (!file.empty()) find_asset(file);
    } catch (const InputError& e) {
        editor.notice = e.what();
        return;
    }
    if (ids.empty()) editor.notice = "no object is selected that could have another " + slot + " map";
    fields_.refuse(
        edit_all(editor.document, ids, slot + " map", editor.gesture, editor.store.path, [&](EntryId, Entry& entry) {
            auto& maps = entry.object()->material.maps;
            file.empty() ? void(maps.erase(slot)) : void(maps[slot] = file);
        }));
}

void PropertiesPanel::draw_light() {
    for (const Property& property : light_properties()) {
        if (property.name == "direction" || property.name == "position") focus_next(wants_keyboard);
        edit(property);
    }
}

bool PropertiesPanel::draw_field(const PropertyField& field, glm::vec3& value, glm::bvec3 mixed) {
    const float speed = field.speed < 0 ? -field.speed * std::max(value.x, 0.1f) : field.speed;
    switch (field.kind) {
        case PropertyField::number:
            return fields_.number(field.label, field.help, value.x, speed, field.lower, field.upper, mixed.x);
        case PropertyField::numbers:
            return fields_.numbers(field.label, field.help, value, speed, mixed);
        case PropertyField::color:
            return fields_.color(field.label, field.help, value, field.upper, mixed);
        case PropertyField::choice:
            return fields_.choice(field.label, {"directional", "point", "spot"}, value.x, mixed.x);
        case PropertyField::check:
            break;
    }
    bool on = value.x == 1.0f;
    const bool changed = fields_.check(field.label, field.help, on, mixed.x);
    if (changed) value.x = on ? 1.0f : 0.0f;
    return changed;
}

void PropertiesPanel::edit(const Property& property) {
    const SharedValue shared = shared_value(editor.document, together_, property);
    if (shared.ids.empty()) return;
    glm::vec3 value = shared.value;
    // Typing the active entry's own number over a dash must count, although it equals the old value.
    for (int i = 0; i < 3; ++i)
        if (shared.mixed[i]) value[i] = std::nextafter(value[i], INFINITY);
    const glm::vec3 before = value;
    const bool changed = draw_field(property.field, value, shared.mixed);
    if (!resettable(editor.document, shared.ids, property).empty()) {
        ImGui::SameLine(ImGui::GetContentRegionMax().x - ImGui::GetFrameHeight());
        ImGui::PushID(property.name.c_str());
        const bool resets = reset_button(property.name);
        ImGui::PopID();
        if (resets) return fields_.refuse(reset_property(editor.document, shared.ids, property, editor.store.path));
    }
    if (!changed) return;
    fields_.refuse(set_property(editor.document, shared.ids, property, value, glm::notEqual(value, before),
                                editor.gesture, editor.store.path));
}

// It is drawn when nobody drags: a new material means its textures' levels again.
void MaterialBall::draw(EntryId id, const DrawItem& item) {
    SceneFile shows = material_ball(*editor.document.at(id).object(), item);
    if (!files_.is_current(scene.images())) {  // they were read again
        preview.forget();
        made_.forget();
    }
    if (!ImGui::IsMouseDown(ImGuiMouseButton_Left) && !made_.is_current(scene_text(shows))) due_ = std::move(shows);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float pixel = std::max(1.0f, std::floor(ImGui::GetFontSize() / 15.0f));
    if (picture_.width) draw_pixels(picture_, at, pixel);
    ImGui::Dummy({pixel * float(size), pixel * float(size)});
    log_place("ball");
}

void MaterialBall::make() {
    picture_ = preview.draw(*view_.gpu, *std::exchange(due_, std::nullopt), glm::uvec2(size));
    log_event("ball drawn");
    view_.changed = true;
}

}  // namespace lightwalk
