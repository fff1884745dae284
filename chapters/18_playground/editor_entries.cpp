// The editor's entries: selection, drawn items, and new entries.
#include <algorithm>

#include "18_playground/editor.h"
#include "18_playground/gltf.h"
#include "common/base/files.h"
#include "common/scene/file_view.h"

namespace lightwalk {

void Editor::select_item(const Scene& scene, std::optional<uint32_t> item, bool add) {
    EntryId id = no_entry;
    if (item && *item < scene.items.size()) id = live.entry_of(scene.items[*item].object);
    if (id != no_entry && is_locked(document, id)) id = no_entry;
    if (id == no_entry) {
        if (!add) selection.clear();
    } else if (add) {
        selection.toggle(id);
    } else {
        selection.set({id});
    }
    if (id != no_entry) tree.show(document, id);
}

std::optional<EntryId> Editor::light_at(const View& view, glm::vec2 cursor_px) const {
    std::optional<EntryId> nearest;
    float least = 9.0f * scale;
    for (const EntryId id : document.at(root_entry).children) {
        const Entry& entry = document.at(id);
        if (!entry.light() || entry.hidden || entry.locked || entry.light()->kind == Light::Kind::directional) continue;
        const auto pixel = on_screen(view, entry.light()->position);
        if (!pixel || glm::length(*pixel - cursor_px) >= least) continue;
        least = glm::length(*pixel - cursor_px);
        nearest = id;
    }
    return nearest;
}

std::vector<uint32_t> Editor::selected_items(const Scene& scene) const { return items_of(scene, selection.ids); }

std::vector<uint32_t> Editor::items_of(const Scene& scene, const std::vector<EntryId>& ids) const {
    std::vector<uint32_t> chosen(scene.file.objects.size(), 0);
    for (size_t i = 0; i < ids.size(); ++i)  // of the scene as a whole, which is everything, nothing is marked
        if (ids[i] != root_entry && document.find(ids[i]))
            for (const EntryId one : with_children(document, ids[i]))
                if (const uint32_t object = live.object_of(one); object < chosen.size())
                    chosen[object] = static_cast<uint32_t>(i + 1);
    std::vector<uint32_t> flags;
    flags.reserve(scene.items.size());
    for (const DrawItem& item : scene.items) flags.push_back(item.object < chosen.size() ? chosen[item.object] : 0u);
    return flags;
}

Bounds Editor::selected_bounds(const Scene& scene) const {
    Bounds box;
    const std::vector<uint32_t> flags = selected_items(scene);
    for (size_t i = 0; i < flags.size(); ++i)
        if (flags[i]) box.add(scene.items[i].bounds);
    for (const EntryId id : selection.ids) {
        const Entry* const entry = document.find(id);
        const bool light = entry && entry->light() && !is_sun(*entry),
                   hidden = entry && entry->object() && is_hidden(document, id);
        if (!light && !hidden) continue;
        const glm::vec3 place(world_of(document, id)[3]);
        box.add(place - 0.5f);
        box.add(place + 0.5f);
    }
    return box;
}

void Editor::remove_selected() {
    if (const Said said = remove(document, selection.ids); !said.empty()) notice = said;
    selection.drop_missing(document);
}

void Editor::group_selected(const Scene& scene) {
    const std::vector<uint32_t> flags = items_of(scene, movable(document, selection.ids));
    Bounds around;
    for (size_t i = 0; i < flags.size(); ++i)
        if (flags[i]) around.add(scene.items[i].bounds);
    if (const EntryId made = group(document, selection.ids, "group", around); made != no_entry)
        selection.set({made});
    else
        notice = "no object is selected that could be grouped";
}

std::filesystem::path asset_name(const std::filesystem::path& file) {
    const std::filesystem::path assets = course_root() / "assets";
    return lies_below(file, assets)
               ? std::filesystem::weakly_canonical(file).lexically_relative(std::filesystem::weakly_canonical(assets))
               : std::filesystem::absolute(file);
}

EntryId Editor::add_model(const std::filesystem::path& given, const Placement& placement) {
    const std::filesystem::path file = find_asset(given);
    SceneObject object;
    object.model = asset_name(file);
    object.name = file.stem().string();
    object.position = placement.position;
    object.rotation_deg = placement.rotation_deg;
    object.scale = placement.scale;
    const EntryId id = lightwalk::add_object(document, object);
    selection.set({id});
    return id;
}

EntryId Editor::add_light(const Light& light) {
    const EntryId id = lightwalk::add_light(document, light);
    selection.set({id});
    return id;
}

Editor::Offered Editor::offered(const Scene& scene, EntryId object) const {
    Offered all;
    const uint32_t place = live.object_of(object);
    const auto item =
        std::find_if(scene.items.begin(), scene.items.end(), [&](const DrawItem& one) { return one.object == place; });
    if (item == scene.items.end()) return all;
    const Model& model = item->model->model;
    const glm::mat4 world = world_of(document, object);
    const auto node = [&](uint32_t number) { return world * item->model->nodes[number]; };
    for (const FileCamera& camera : model.cameras) {
        const float distance_m = glm::length(scene.bounds.center() - glm::vec3(node(camera.node)[3]));
        const std::string number = std::to_string(all.cameras.size() + 1);
        all.cameras.emplace_back(camera.name.empty() ? number : camera.name,
                                 placed(camera, node(camera.node), distance_m));
    }
    for (const FileLight& light : model.lights) all.lights.push_back(placed(light, node(light.node)));
    return all;
}

void Editor::export_to(const Scene& scene, const std::filesystem::path& file) {
    const std::string left_out = export_gltf(document, scene, file);
    notice = "exported " + file.string() + (left_out.empty() ? "" : "; left out: " + left_out);
}

}  // namespace lightwalk
