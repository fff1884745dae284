// Edits of a loaded scene, without reloading.
#include <algorithm>
#include <string_view>
#include <unordered_map>
#include <utility>

#include "common/scene/scene.h"

namespace lightwalk {
namespace {

// Overrides that disable the metallic-roughness texture.
bool replaces_map(const MaterialOverride& m) { return m.roughness || m.metalness || m.specular || m.shininess; }

bool same_maps(const MaterialOverride& a, const MaterialOverride& b) {
    return a.maps == b.maps && replaces_map(a) == replaces_map(b);
}

// True if batches, shader variants, holes and substance tables stay valid.
bool differ_in_numbers(const DrawItem& a, const DrawItem& b) {
    return a.transparent == b.transparent && a.two_sided == b.two_sided && a.material.blend == b.material.blend &&
           a.material.microfacets == b.material.microfacets &&
           (a.material.opacity < 1.0f) == (b.material.opacity < 1.0f) && (a.roughness < 0) == (b.roughness < 0) &&
           (a.metalness < 0) == (b.metalness < 0);
}

bool same_role(const GivenRole& a, const GivenRole& b) { return a.object == b.object && a.materials == b.materials; }

}  // namespace

void Scene::find_items() {
    if (!first_item_.empty()) return;
    first_item_.assign(objects_.size() + 1, 0);
    for (const DrawItem& item : items) ++first_item_[item.object + 1];
    for (size_t i = 1; i < first_item_.size(); ++i) first_item_[i] += first_item_[i - 1];
    items_of_.resize(items.size());
    std::vector<uint32_t> next = first_item_;
    for (uint32_t i = 0; i < items.size(); ++i) items_of_[next[items[i].object]++] = i;
}

bool Scene::edit(std::span<const Edit> edits) {
    if (edits.empty()) return true;
    find_items();
    std::vector<std::pair<uint32_t, DrawItem>> painted;
    for (const Edit& one : edits) {
        const MaterialOverride &shown = file.objects.at(one.object).material, &wanted = one.now->material;
        if (wanted == shown) continue;
        if (!same_maps(shown, wanted)) return false;
        for (uint32_t at = first_item_[one.object]; at < first_item_[one.object + 1]; ++at) {
            const DrawItem& before = items[items_of_[at]];
            DrawItem& now = painted.emplace_back(items_of_[at], before).second;
            set_material(now, wanted, file.bare);
            if (!differ_in_numbers(before, now)) return false;
        }
    }
    for (auto& [place, item] : painted) {
        items[place] = std::move(item);
        to_paint_[place] = true;
    }
    std::vector<bool> moved(objects_.size(), false);
    bool any_moved = false;
    for (const auto& [place, now] : edits) {
        SceneObject& object = file.objects[place];
        object.material = now->material;
        if (object.position == now->position && object.rotation_deg == now->rotation_deg && object.scale == now->scale)
            continue;
        object.position = now->position;
        object.rotation_deg = now->rotation_deg;
        object.scale = now->scale;
        objects_[place].local = local_transform(object, time_s_);
        moved[place] = any_moved = true;
    }
    epoch = Epoch::next();
    if (any_moved) move(std::move(moved));
    return true;
}

void Scene::move(std::vector<bool> moved) {
    bool turned_over = false;
    for (size_t i = 0; i < objects_.size(); ++i) {
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
    bounds = {};
    for (const DrawItem& item : items) bounds.add(item.bounds);
    if (turned_over) find_batches();
}

bool Scene::repaint(bool bare, float emission) {
    if (file.bare == bare && file.emission == emission) return true;
    file.bare = bare;
    file.emission = emission;
    bool same_kinds = true;
    for (DrawItem& item : items) {
        const DrawItem before = item;
        set_material(item, file.objects[item.object].material, bare);
        same_kinds &= differ_in_numbers(before, item);
    }
    if (!same_kinds)
        for (DrawItem& item : items) static_cast<MapImages&>(item.maps) = item.loaded_maps;
    to_paint_.assign(items.size(), true);
    epoch = Epoch::next();
    return same_kinds;
}

// Fallible steps come first, with the old lists kept. Items are moved, or copied if several objects share them.
bool Scene::replace_objects(Gpu& gpu, std::vector<SceneObject> objects, std::span<const uint32_t> from,
                            const ModelLoader& loader) {
    find_items();
    const std::vector<uint32_t> first = first_item_, place_of = items_of_;
    std::vector<SceneObject> old_objects = std::exchange(file.objects, std::move(objects));
    std::vector<DrawItem> old_items = std::exchange(items, {});
    const auto alike = [&](size_t old, const SceneObject& object) {
        return first[old] != first[old + 1] && old_objects[old].model.native() == object.model.native() &&
               old_objects[old].ground == object.ground && old_objects[old].material == object.material &&
               same_role(old_objects[old].role, object.role);
    };
    struct Source {
        uint32_t old = new_object;  // object that provides the items; new_object: loaded
        size_t begin = 0, end = 0;
    };
    std::vector<Source> sources(file.objects.size());
    std::vector<uint32_t> uses(old_objects.size(), 0);
    std::unordered_multimap<std::string_view, uint32_t> by_model;
    size_t count = 0;
    try {
        link_objects();
        const Roles roles(file);
        for (size_t i = 0; i < file.objects.size(); ++i) {
            const SceneObject& object = file.objects[i];
            if (object.model.empty() || objects_[i].hidden) continue;
            Source& source = sources[i];
            if (from[i] != new_object && alike(from[i], object)) source.old = from[i];
            if (source.old == new_object && by_model.empty())
                for (uint32_t k = 0; k < old_objects.size(); ++k)
                    if (first[k] != first[k + 1]) by_model.emplace(old_objects[k].model.native(), k);
            if (source.old == new_object) {
                const auto [begin, end] = by_model.equal_range(object.model.native());
                for (auto other = begin; other != end && source.old == new_object; ++other)
                    if (alike(other->second, object)) source.old = other->second;
            }
            if (source.old == new_object) {
                source.begin = items.size();
                add_items(gpu, i, roles, loader);
                source.end = items.size();
                count += source.end - source.begin;
            } else {
                ++uses[source.old];
                count += first[source.old + 1] - first[source.old];
            }
        }
    } catch (...) {
        file.objects = std::move(old_objects);
        items = std::move(old_items);
        link_objects();
        throw;
    }
    std::vector<DrawItem> loaded = std::exchange(items, {});
    items.reserve(count);
    for (size_t i = 0; i < sources.size(); ++i) {
        const Source& source = sources[i];
        const size_t begin = items.size();
        for (size_t at = source.begin; at < source.end; ++at) items.push_back(std::move(loaded[at]));
        const bool last = source.old != new_object && --uses[source.old] == 0;
        for (uint32_t at = 0; source.old != new_object && at < first[source.old + 1] - first[source.old]; ++at) {
            DrawItem& item = old_items[place_of[first[source.old] + at]];
            if (last)
                items.push_back(std::move(item));
            else
                items.push_back(item);
        }
        for (size_t at = begin; at < items.size(); ++at) items[at].object = static_cast<uint32_t>(i);
    }
    const bool loads = !loaded.empty();
    if (loads)
        for (DrawItem& item : items) static_cast<MapImages&>(item.maps) = item.loaded_maps;
    std::erase_if(moving_models_, [&](const std::shared_ptr<GpuModel>& model) {
        return std::none_of(items.begin(), items.end(), [&](const DrawItem& item) { return item.model == model; });
    });
    place_and_upload(gpu);
    return loads;
}

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
