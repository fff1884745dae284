// Edits of a loaded scene: objects moved, added, removed and changed, without loading it again.
#include <algorithm>
#include <utility>

#include "common/scene/scene.h"

namespace lightwalk {
namespace {

bool same_material(const MaterialOverride& a, const MaterialOverride& b) {
    return a.diffuse == b.diffuse && a.specular == b.specular && a.emissive == b.emissive &&
           a.shininess == b.shininess && a.opacity == b.opacity && a.roughness == b.roughness &&
           a.metalness == b.metalness && a.blend == b.blend && a.maps == b.maps;
}

bool same_role(const GivenRole& a, const GivenRole& b) { return a.object == b.object && a.materials == b.materials; }

}  // namespace

// [move]
void Scene::move(std::span<const Move> moves) {
    if (moves.empty()) return;
    if (first_item_.empty()) {  // which items are whose, found once after each load
        first_item_.assign(objects_.size() + 1, 0);
        for (const DrawItem& item : items) ++first_item_[item.object + 1];
        for (size_t i = 1; i < first_item_.size(); ++i) first_item_[i] += first_item_[i - 1];
        items_of_.resize(items.size());
        std::vector<uint32_t> next = first_item_;
        for (uint32_t i = 0; i < items.size(); ++i) items_of_[next[items[i].object]++] = i;
    }
    std::vector<bool> moved(objects_.size(), false);
    size_t first = objects_.size();
    for (const Move& one : moves) {
        SceneObject& object = file.objects.at(one.object);
        object.position = one.position, object.rotation_deg = one.rotation_deg, object.scale = one.scale;
        objects_[one.object].local = local_transform(object, time_s_);
        moved[one.object] = true;
        first = std::min<size_t>(first, one.object);
    }
    bool turned_over = false;
    for (size_t i = first; i < objects_.size(); ++i) {
        Placed& object = objects_[i];
        if (object.parent >= 0 && moved[static_cast<size_t>(object.parent)]) moved[i] = true;
        if (!moved[i]) continue;
        object.world =
            object.parent < 0 ? object.local : objects_[static_cast<size_t>(object.parent)].world * object.local;
        for (uint32_t at = first_item_[i]; at < first_item_[i + 1]; ++at) {
            DrawItem& item = items[items_of_[at]];
            const bool was_mirrored = item.mirrored;
            if (place(item)) to_upload_[items_of_[at]] = true;
            turned_over |= item.mirrored != was_mirrored;
        }
    }
    placed = next_placement();
    bounds = {};
    for (const DrawItem& item : items) bounds.add(item.bounds);
    if (turned_over) find_batches();
}
// [/move]

// [replace_objects]
bool Scene::replace_objects(Gpu& gpu, std::vector<SceneObject> objects, std::span<const uint32_t> from,
                            const ModelLoader& loader) {
    std::vector<DrawItem> old_items = items;
    std::vector<SceneObject> old_objects = std::exchange(file.objects, std::move(objects));
    std::vector<std::vector<uint32_t>> of_object(old_objects.size());
    for (uint32_t i = 0; i < old_items.size(); ++i) of_object[old_items[i].object].push_back(i);
    const auto alike = [&](size_t old, const SceneObject& object) {
        return !of_object[old].empty() && old_objects[old].model == object.model &&
               same_material(old_objects[old].material, object.material) &&
               same_role(old_objects[old].role, object.role);
    };
    std::multimap<std::string, size_t> by_model;  // of what a copy may take its items from
    bool loads = false;
    try {
        items.clear();
        link_objects();
        const Roles roles(file);
        for (size_t i = 0; i < file.objects.size(); ++i) {
            const SceneObject& object = file.objects[i];
            if (object.model.empty() || objects_[i].hidden) continue;
            size_t source = from[i];
            if (source == new_object || !alike(source, object)) {
                if (by_model.empty())
                    for (size_t k = 0; k < old_objects.size(); ++k)
                        if (!of_object[k].empty()) by_model.emplace(old_objects[k].model.string(), k);
                source = new_object;
                const auto [first, last] = by_model.equal_range(object.model.string());
                for (auto other = first; other != last && source == new_object; ++other)
                    if (alike(other->second, object)) source = other->second;
            }
            if (source == new_object) {
                add_items(gpu, i, roles, loader);
                loads = true;
                continue;
            }
            for (const uint32_t item : of_object[source]) {
                items.push_back(old_items[item]);
                items.back().object = static_cast<uint32_t>(i);
            }
        }
    } catch (...) {
        file.objects = std::move(old_objects);
        items = std::move(old_items);
        link_objects();
        throw;
    }
    if (loads)
        for (DrawItem& item : items) item.maps = item.loaded_maps;
    std::erase_if(moving_models_, [&](const std::shared_ptr<GpuModel>& model) {
        return std::none_of(items.begin(), items.end(), [&](const DrawItem& item) { return item.model == model; });
    });
    place_and_upload(gpu);
    return loads;
}
// [/replace_objects]

void Scene::replace_environment(const Environment& other) {
    const Environment before = std::exchange(file.environment, other);
    const std::shared_ptr<Image> image = environment;
    try {
        load_environment();
    } catch (...) {
        file.environment = before;
        environment = image;
        throw;
    }
}

}  // namespace lightwalk
