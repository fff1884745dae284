// Single entries: names, sizes, equality.
#include "18_playground/document.h"

namespace lightwalk {

const std::string& Entry::name() const {
    static const std::string scene = "scene";
    if (object()) return object()->name;
    return light() ? light()->name : scene;
}

uint64_t bytes_of(const Entry& entry) {
    uint64_t bytes = sizeof(Entry) + entry.children.capacity() * sizeof(EntryId) + entry.name().capacity();
    if (const SceneObject* object = entry.object()) {
        bytes += object->model.native().capacity() + object->motion.path.capacity() * sizeof(Keyframe);
        for (const auto& [slot, file] : object->material.maps) bytes += 96 + slot.capacity() + file.native().capacity();
    } else if (const SceneSettings* settings = entry.settings()) {
        for (const auto& [name, value] : settings->knobs) bytes += 96 + name.capacity() + value.capacity();
    }
    return bytes;
}

bool same_but_placed_and_painted(const SceneObject& a, const SceneObject& b) {
    return a.name == b.name && a.model == b.model && a.ground == b.ground && a.shows == b.shows &&
           a.role.object == b.role.object && a.role.materials == b.role.materials;
}

bool same_but_placed(const SceneObject& a, const SceneObject& b) {
    return same_but_placed_and_painted(a, b) && a.material == b.material;
}

bool same_entry(const Entry& a, const Entry& b) {
    if (a.parent != b.parent || a.children != b.children || a.hidden != b.hidden || a.locked != b.locked ||
        a.included != b.included || a.what.index() != b.what.index())
        return false;
    if (a.light()) return *a.light() == *b.light();
    if (const SceneObject* one = a.object(), *other = b.object(); one)
        return same_but_placed(*one, *other) && one->position == other->position &&
               one->rotation_deg == other->rotation_deg && one->scale == other->scale;
    const SceneSettings &s = *a.settings(), &t = *b.settings();
    return s.knobs == t.knobs && s.ambient == t.ambient && s.background == t.background &&
           s.environment.image == t.environment.image && s.environment.intensity == t.environment.intensity &&
           s.environment.rotation_deg == t.environment.rotation_deg && s.music.file == t.music.file &&
           s.camera.position == t.camera.position && s.camera.target == t.camera.target && s.camera.up == t.camera.up &&
           s.camera.fov_y_rad == t.camera.fov_y_rad && s.camera.near_m == t.camera.near_m &&
           s.camera.far_m == t.camera.far_m && s.bare == t.bare && s.emission == t.emission;
}

std::vector<EntryId> with_children(const Document& document, EntryId id) {
    std::vector<EntryId> all, stack{id};
    while (!stack.empty()) {
        all.push_back(stack.back());
        const Entry& entry = document.at(stack.back());
        stack.pop_back();
        stack.insert(stack.end(), entry.children.rbegin(), entry.children.rend());
    }
    return all;
}

}  // namespace lightwalk
