#include "18_playground/live_scene.h"

#include <algorithm>

#include "common/base/files.h"
#include "common/scene/material_maps.h"

namespace lightwalk {
void LiveScene::number(const Exported& all) {
    objects_ = all.objects;
    lights_ = all.lights;
    places_.clear();
    light_places_.clear();
    for (size_t i = 0; i < objects_.size(); ++i) places_[objects_[i]] = static_cast<uint32_t>(i);
    for (size_t i = 0; i < lights_.size(); ++i) light_places_[lights_[i]] = static_cast<uint32_t>(i);
}

void LiveScene::begin(Document& document, Scene& scene) {
    document.take_changes();
    const Exported all = exported(document);
    number(all);
    scene.file.lights = all.scene.lights;
    scene.file.hidden_lights = all.scene.hidden_lights;
}

uint32_t LiveScene::object_of(EntryId id) const {
    const auto place = places_.find(id);
    return place == places_.end() ? Scene::new_object : place->second;
}

// None where an entry needs more.
std::optional<LiveScene::Edits> LiveScene::edits_of(const Document& document, const Scene& scene,
                                                    const std::vector<EntryId>& entries) const {
    Edits edits;
    for (const EntryId id : entries) {
        const Entry* const entry = document.find(id);
        if (!entry) continue;  // made and unmade meanwhile
        if (const SceneObject* object = entry->object()) {
            const auto place = places_.find(id);
            if (place == places_.end()) return {};
            const SceneObject& shown = scene.file.objects[place->second];
            if (!same_but_placed_and_painted(*object, shown) || entry->hidden != shown.hidden) return {};
            edits.objects.push_back({place->second, object});
        } else if (entry->light()) {
            if (entry->hidden == light_places_.contains(id)) return {};
            if (!entry->hidden) edits.lights.push_back(id);
        }
    }
    return edits;
}

// Takes models and textures that cannot be read from `objects`. An object that is shown already keeps its own, even if their
// files are gone by now.
void LiveScene::leave_out(Gpu& gpu, Scene& scene, std::vector<SceneObject>& objects, const std::vector<uint32_t>& from,
                          const ModelLoader& loader, const std::function<void(const InputError&)>& note) const {
    for (size_t i = 0; i < objects.size(); ++i) {
        SceneObject& object = objects[i];
        if (from[i] < scene.file.objects.size() && same_but_placed(object, scene.file.objects[from[i]])) continue;
        if (object.model.empty() || object.hidden) continue;
        try {
            scene.models().load(gpu, find_asset(object.model), loader);
        } catch (const InputError& e) {
            note(e);
            object.model.clear();
        }
        std::erase_if(object.material.maps, [&](const auto& map) {
            std::set<std::string> warned;
            try {
                load_maps(scene.images(gpu), {}, {.maps = {map}}, warned);
                return false;
            } catch (const InputError& e) {
                note(e);
                return true;
            }
        });
    }
}

// [update]
bool LiveScene::update(Gpu& gpu, Document& document, Scene& scene, const ModelLoader& loader,
                       std::vector<std::string>* without) {
    const auto note = [&](const InputError& e) {
        if (!without) throw;
        if (std::find(without->begin(), without->end(), e.what()) == without->end()) without->emplace_back(e.what());
    };
    loads = false;
    const Document::Changes changes = document.take_changes();
    if (changes.entries.empty() && !changes.structure) return false;
    const SceneSettings& settings = document.settings();
    scene.file.ambient = settings.ambient;
    scene.file.background = settings.background;
    const bool same_kinds = scene.repaint(settings.bare, settings.emission);
    const Environment& shown = scene.file.environment;
    try {
        if (settings.environment.image != shown.image)
            scene.replace_environment(settings.environment);
        else
            scene.file.environment = settings.environment;
    } catch (const InputError& e) { note(e); }

    const auto edits = changes.structure || !same_kinds ? std::nullopt : edits_of(document, scene, changes.entries);
    if (edits && scene.edit(edits->objects)) {
        for (const EntryId id : edits->lights) scene.file.lights[light_places_.at(id)] = light_of(document.at(id));
        return false;
    }
    Exported all = exported(document);
    std::vector<uint32_t> from;
    from.reserve(all.objects.size());
    for (const EntryId id : all.objects) from.push_back(object_of(id));
    if (without) leave_out(gpu, scene, all.scene.objects, from, loader, note);
    loads = scene.replace_objects(gpu, std::move(all.scene.objects), from, loader) || !same_kinds;
    scene.file.lights = std::move(all.scene.lights);
    scene.file.hidden_lights = std::move(all.scene.hidden_lights);
    number(all);
    return true;
}
// [/update]

}  // namespace lightwalk
