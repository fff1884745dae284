#include "18_playground/commands.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "03_attenuation/scattered_lights.h"
#include "18_playground/tree.h"

namespace lightwalk {

void Selection::set(std::vector<EntryId> chosen) {
    ids.clear();
    members_.clear();
    for (const EntryId id : chosen)
        if (members_.insert(id).second) ids.push_back(id);
}

void Selection::toggle(EntryId id) {
    if (members_.erase(id))
        std::erase(ids, id);
    else {
        members_.insert(id);
        ids.push_back(id);
    }
}

void Selection::drop_missing(const Document& document) {
    std::vector<EntryId> left;
    for (const EntryId id : ids)
        if (document.find(id)) left.push_back(id);
    set(std::move(left));
}

std::string free_name(const Document& document, const std::string& name, const std::string& own, NextNumbers* numbers) {
    const auto taken = [&](const std::string& one) { return one != own && document.has_name(one); };
    if (name.empty() || !taken(name)) return name;
    std::string stem = name;
    int number = 2;
    if (const size_t space = stem.find_last_of(' '); space != stem.npos && space + 1 < stem.size() &&
                                                     stem.size() - space < 8 &&
                                                     stem.find_first_not_of("0123456789", space + 1) == stem.npos) {
        number = std::stoi(stem.substr(space + 1)) + 1;
        stem.resize(space);
    }
    int* const next = numbers ? &(*numbers)[stem] : nullptr;
    if (next) number = std::max(number, *next);
    std::string free;
    for (; free.empty() || taken(free); ++number) free = fmt::format("{} {}", stem, number);
    if (next) *next = number;
    return free;
}

namespace {

template <class Wanted>
bool any_above(const Document& document, EntryId id, Wanted wanted) {
    for (; id != no_entry; id = document.at(id).parent)
        if (wanted(document.at(id))) return true;
    return false;
}

// A parent is known by its name in the file.
void name_parent(Document& document, EntryId id) {
    if (id != root_entry && document.at(id).name().empty()) document.rename(id, free_name(document, "object"));
}

}  // namespace

bool is_locked(const Document& document, EntryId id) {
    return any_above(document, id, [](const Entry& entry) { return entry.locked; });
}

bool is_hidden(const Document& document, EntryId id) {
    return any_above(document, id, [](const Entry& entry) { return entry.hidden; });
}

std::vector<EntryId> movable(const Document& document, const std::vector<EntryId>& ids) {
    const std::set<EntryId> wanted(ids.begin(), ids.end());
    std::vector<EntryId> found;
    for (const EntryId id : wanted) {
        if (id == root_entry || !document.find(id) || is_locked(document, id)) continue;
        bool below = false;
        for (EntryId up = document.at(id).parent; up != no_entry && !below; up = document.at(up).parent)
            below = wanted.contains(up);
        if (!below) found.push_back(id);
    }
    if (found.size() < 2) return found;
    // Siblings in their parent's order; parents by id.
    std::map<EntryId, std::set<EntryId>> by_parent;
    for (const EntryId id : found) by_parent[document.at(id).parent].insert(id);
    found.clear();
    for (const auto& [parent, children] : by_parent)
        for (const EntryId child : document.at(parent).children)
            if (children.contains(child)) found.push_back(child);
    return found;
}

EntryId add_object(Document& document, SceneObject object, EntryId parent) {
    object.parent.clear();
    object.name = free_name(document, clean_name(object.name));
    document.begin("add " + object.name);
    name_parent(document, parent);
    const EntryId id = document.add(parent, {.what = std::move(object)});
    document.commit();
    return id;
}

EntryId add_light(Document& document, const Light& light) {
    document.begin("add a light");
    const EntryId id = document.add(root_entry, {.what = light});
    document.commit();
    return id;
}

std::vector<EntryId> add_lights(Document& document, const std::string& step, const std::vector<Light>& lights) {
    document.begin(step);
    std::vector<EntryId> ids;
    for (const Light& light : lights) ids.push_back(document.add(root_entry, {.what = light}));
    document.commit();
    return ids;
}

std::vector<EntryId> scatter(Document& document, const Bounds& where, int count, unsigned seed) {
    return add_lights(document, fmt::format("scatter {} {}", count, count == 1 ? "light" : "lights"),
                      scatter_lights(where, count, seed));
}

Said remove(Document& document, const std::vector<EntryId>& ids) {
    const std::vector<EntryId> chosen = movable(document, ids);
    if (chosen.empty() && std::count(ids.begin(), ids.end(), root_entry))
        return "camera, environment, sky, terrain, water, fog and effects belong to the scene: they cannot be deleted";
    if (chosen.empty()) return ids.empty() ? "nothing is selected" : "what is selected is locked";
    document.begin(chosen.size() == 1 ? "delete " + document.at(chosen[0]).name()
                                      : fmt::format("delete {} entries", chosen.size()));
    document.remove(chosen);
    for (const EntryId id : with_children(document, root_entry))  // a screen without its object is blank
        if (const SceneObject* screen = document.at(id).object();
            screen && !screen->shows.empty() && !document.has_name(screen->shows))
            document.edit(id).object()->shows.clear();
    document.commit();
    return "";
}

namespace {

EntryId copy(Document& document, EntryId from, EntryId parent, NextNumbers& numbers) {
    Entry entry = document.at(from);
    const std::vector<EntryId> children = std::exchange(entry.children, {});
    if (SceneObject* object = entry.object()) object->name = free_name(document, object->name, "", &numbers);
    entry.included = false;
    const EntryId id = document.add(parent, std::move(entry));
    for (const EntryId child : children) copy(document, child, id, numbers);
    return id;
}

}  // namespace

// Copies are added at the end of their parents' lists, which are then written once in the right order: adding in the middle
// would move all that stands behind, each time.
std::vector<EntryId> duplicate(Document& document, const std::vector<EntryId>& ids) {
    NextNumbers numbers;
    std::vector<EntryId> copies;
    std::map<EntryId, std::unordered_map<EntryId, EntryId>> copy_of;  // by parent
    document.begin("duplicate");
    for (const EntryId id : movable(document, ids)) {
        const EntryId parent = document.at(id).parent;
        copies.push_back(copy_of[parent][id] = copy(document, id, parent, numbers));
    }
    for (const auto& [parent, made] : copy_of) {
        std::vector<EntryId> order = document.at(parent).children;
        order.resize(order.size() - made.size());
        std::vector<EntryId> both;
        both.reserve(order.size() + made.size());
        for (const EntryId child : order) {
            both.push_back(child);
            if (const auto found = made.find(child); found != made.end()) both.push_back(found->second);
        }
        document.order_children(parent, std::move(both));
    }
    document.commit();
    return copies;
}

namespace {

// Within a step that is open.
Said move_to(Document& document, const std::vector<EntryId>& ids, EntryId parent, size_t place) {
    if (parent != root_entry && !document.at(parent).object()) return "only an object can be a parent";
    std::vector<TreeNode> nodes;
    std::vector<EntryId> entries = with_children(document, root_entry);
    std::unordered_map<EntryId, int32_t> places;
    for (const EntryId id : entries) {
        places.emplace(id, static_cast<int32_t>(nodes.size()));
        const Entry& entry = document.at(id);
        TreeNode node{entry.parent == no_entry ? -1 : places.at(entry.parent), glm::mat4(1.0f)};
        if (node.parent >= 0) node.world = nodes[static_cast<size_t>(node.parent)].world;
        if (const SceneObject* object = entry.object()) node.world = node.world * local_transform(*object);
        nodes.push_back(node);
    }
    std::vector<uint32_t> selected;
    for (const EntryId id : ids)
        if (id != root_entry && document.find(id)) selected.push_back(static_cast<uint32_t>(places.at(id)));
    const auto moves = sort_tree_moves(nodes, selected, places.at(parent));
    if (!moves) return "that would make a circle: an object cannot hang below itself";
    Said said;
    name_parent(document, parent);
    std::vector<EntryId> moved;
    for (const TreeMove& move : *moves) {
        const EntryId id = entries.at(move.node);
        if (is_locked(document, id)) {
            said = document.at(id).name() + " is locked";
            continue;
        }
        if (document.at(id).light() && parent != root_entry) {
            said = "a light hangs below no object";
            continue;
        }
        if (const SceneObject* object = document.at(id).object(); object && document.at(id).parent != parent) {
            bool exact = true;
            const Placement own = placement_of(move.local, object->rotation_deg, &exact);
            if (!exact) said = object->name + " was sheared by its parents' scales; its new place has no shear";
            SceneObject& edited = *document.edit(id).object();
            edited.position = own.position;
            edited.rotation_deg = own.rotation_deg;
            edited.scale = own.scale;
        }
        moved.push_back(id);
    }
    if (!moved.empty()) document.move_below(moved, parent, place);
    return said;
}

}  // namespace

Said reparent(Document& document, const std::vector<EntryId>& ids, EntryId parent, size_t place) {
    if (is_locked(document, parent)) return "the parent is locked";
    document.begin("move in the tree");
    const Said said = move_to(document, ids, parent, place);
    document.commit();
    return said;
}

EntryId group(Document& document, const std::vector<EntryId>& ids, const std::string& name, const Bounds& around) {
    std::vector<EntryId> objects;
    Bounds places;
    for (const EntryId id : movable(document, ids))
        if (document.at(id).object()) {
            objects.push_back(id);
            places.add(glm::vec3(world_of(document, id)[3]));
        }
    if (objects.empty()) return no_entry;
    const EntryId first = document.at(objects[0]).parent;
    const bool siblings =
        std::all_of(objects.begin(), objects.end(), [&](EntryId id) { return document.at(id).parent == first; });
    const EntryId parent = siblings ? first : root_entry;
    SceneObject own;
    own.name = free_name(document, clean_name(name));
    const glm::dvec4 middle((around.empty() ? places : around).center(), 1.0);
    own.position = glm::vec3(glm::inverse(glm::dmat4(world_of(document, parent))) * middle);
    if (!cannot_be_placed(placement_of(own)).empty()) own.position = glm::vec3(0.0f);
    document.begin("group");
    const EntryId id = document.add(parent, {.what = own});
    if (siblings) {  // turned and scaled as before, to the bit: the group only stands elsewhere
        for (const EntryId one : objects) document.edit(one).object()->position -= own.position;
        document.move_below(objects, id);
    } else {
        move_to(document, objects, id, SIZE_MAX);
    }
    document.commit();
    return id;
}

Said rename(Document& document, EntryId id, const std::string& name) {
    const Entry& entry = document.at(id);
    if (id == root_entry) return "the scene is called like its file";
    if (is_locked(document, id)) return "it is locked";
    std::string wanted = clean_name(name);
    if (wanted == entry.name()) return "";
    if (wanted.empty() && !entry.children.empty()) return "what has children has a name";
    const std::string before = entry.name();
    Said said;
    if (entry.object()) {
        wanted = free_name(document, wanted, before);
        if (wanted != clean_name(name)) said = "another object has that name; this is " + wanted;
        if (wanted == before) return said;
    }
    document.begin("rename " + before);
    document.rename(id, wanted);
    if (document.at(id).object() && !before.empty())  // screens refer to names
        for (const EntryId other : with_children(document, root_entry))
            if (const SceneObject* object = document.at(other).object(); object && object->shows == before)
                document.edit(other).object()->shows = wanted;
    document.commit();
    return said;
}

namespace {

void set_switch(Document& document, const std::vector<EntryId>& ids, const char* step, bool Entry::*which, bool on) {
    std::vector<EntryId> others;
    for (const EntryId id : ids)
        if (id != root_entry && document.find(id) && document.at(id).*which != on) others.push_back(id);
    document.begin(others.size() == 1 ? fmt::format("{} {}", step, shown_name(document.at(others[0])))
                                      : fmt::format("{} {} entries", step, others.size()));
    for (const EntryId id : others) document.edit(id).*which = on;
    document.commit();
}

}  // namespace

void set_hidden(Document& document, const std::vector<EntryId>& ids, bool hidden) {
    set_switch(document, ids, hidden ? "hide" : "show", &Entry::hidden, hidden);
}

void set_locked(Document& document, const std::vector<EntryId>& ids, bool locked) {
    set_switch(document, ids, locked ? "lock" : "unlock", &Entry::locked, locked);
}

void set_knobs(Document& document, const std::map<std::string, std::string>& knobs, uint64_t gesture) {
    std::string changed;
    for (const auto& [name, value] : knobs) {
        const auto& before = document.settings().knobs;
        if (const auto found = before.find(name); found == before.end() || found->second != value) changed = name;
    }
    if (changed.empty()) return;
    document.begin("set " + changed, gesture);
    for (const auto& [name, value] : knobs) document.edit(root_entry).settings()->knobs[name] = value;
    document.commit();
}

size_t utf8_length(std::string_view text) {
    const auto byte = [&](size_t i) { return static_cast<unsigned char>(text[i]); };
    if (byte(0) < 0x80) return 1;
    const size_t length = byte(0) >= 0xf0 ? 4 : byte(0) >= 0xe0 ? 3 : byte(0) >= 0xc2 ? 2 : 0;
    if (length == 0 || byte(0) > 0xf4 || text.size() < length) return 0;
    uint32_t code = byte(0) & (0xffu >> (length + 1));
    for (size_t i = 1; i < length; ++i) {
        if ((byte(i) & 0xc0) != 0x80) return 0;
        code = code << 6 | (byte(i) & 0x3f);
    }
    const uint32_t least[] = {0, 0, 0x80, 0x800, 0x10000};
    const bool surrogate = code >= 0xd800 && code < 0xe000;
    return code < least[length] || surrogate || code > 0x10ffff ? 0 : length;
}

std::string clean_name(const std::string& name) {
    std::string clean;
    for (size_t i = 0; i < name.size();) {
        const size_t length = utf8_length(std::string_view(name).substr(i));
        if (length == 0)
            clean += "\xef\xbf\xbd";
        else if (length == 1 && (static_cast<unsigned char>(name[i]) < 32 || name[i] == 127))
            clean += ' ';
        else
            clean.append(name, i, length);
        i += length == 0 ? 1 : length;
    }
    return clean;
}

EntryId terrain_of(const Document& document) {
    for (const EntryId id : with_children(document, root_entry))
        if (is_terrain(document.at(id))) return id;
    return no_entry;
}

void set_terrain(Document& document, const std::filesystem::path& file, float reach_m, uint64_t gesture) {
    const EntryId now = terrain_of(document);
    if (now == no_entry && file.empty()) return;
    document.begin("terrain", gesture);
    if (file.empty()) {
        document.remove({now});
    } else if (now != no_entry) {
        document.edit(now).object()->model = file;
    } else {
        SceneObject object;
        object.name = free_name(document, "ground");
        object.model = file;
        document.add(root_entry, {.what = std::move(object)});
    }
    if (!file.empty() && document.settings().camera.far_m < reach_m)
        document.edit(root_entry).settings()->camera.far_m = reach_m;
    document.commit();
}

float side_m(const HeightMap& map) {
    const glm::vec2 size_m = map.sample_m * glm::vec2(map.width - 1, map.height - 1);
    return std::min(size_m.x, size_m.y);
}

std::map<std::string, std::string> terrain_knobs(const HeightMap& map, const Bounds& scene) {
    const size_t middle = size_t(map.height / 2) * size_t(map.width) + size_t(map.width / 2);
    const float size_m = scene.empty() ? 1.0f : glm::length(scene.extent());
    const float floor_m = (scene.empty() ? 0.0f : scene.lower.y) - 0.002f * size_m;  // nothing flickers with it
    const float away_m = scene.empty() ? 0.0f : glm::length(glm::vec2(scene.center().x, scene.center().z)) + size_m;
    const float level_m = std::max(0.01f * side_m(map), 1.5f * away_m);
    return {{"air", "sky"},
            {"ground.datum_m", fmt::format("{:.0f}", map.elevation_m[middle] - floor_m)},
            {"ground.plain_km", fmt::format("0,0,{:.3f}", 1e-3f * level_m)},
            {"ground.plain_m", fmt::format("{:.4f}", floor_m)}};
}

}  // namespace lightwalk
