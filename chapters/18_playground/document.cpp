#include "18_playground/document.h"

#include <algorithm>
#include <set>
#include <unordered_set>
#include <utility>

#include "common/base/error.h"

namespace lightwalk {

Document::Document() : Document(SceneFile{}) {}

Document::Document(const SceneFile& scene) {
    slots_.resize(2);
    put(root_entry, std::make_shared<Entry>(
                        Entry{.what = SceneSettings{scene.camera, scene.ambient, scene.background, scene.environment,
                                                    scene.music, scene.knobs, scene.bare, scene.emission}}));
    count_ = 0;
    std::unordered_map<std::string, EntryId> by_name;
    const auto append = [&](EntryId parent, Entry entry) {
        const EntryId id = static_cast<EntryId>(slots_.size());
        slots_.emplace_back();
        entry.parent = parent;
        slots_[parent].entry->children.push_back(id);
        put(id, std::make_shared<Entry>(std::move(entry)));
        return id;
    };
    for (const SceneObject& object : scene.objects) {
        SceneObject own = object;
        own.parent.clear();
        own.hidden = own.locked = false;
        const EntryId id = append(object.parent.empty() ? root_entry : by_name.at(object.parent),
                                  {.what = std::move(own), .hidden = object.hidden, .locked = object.locked});
        if (!object.name.empty()) by_name[object.name] = id;
    }
    const auto append_light = [&](Light light, bool is_hidden) {
        const bool locked = std::exchange(light.locked, false);
        append(root_entry, {.what = std::move(light), .hidden = is_hidden, .locked = locked});
    };
    auto hidden = scene.hidden_lights.begin();
    for (size_t i = 0; i <= scene.lights.size(); ++i) {
        for (; hidden != scene.hidden_lights.end() && (hidden->before <= i || i == scene.lights.size()); ++hidden)
            append_light(hidden->light, true);
        if (i < scene.lights.size()) append_light(scene.lights[i], false);
    }
    note_structure();
}

const Entry& Document::at(EntryId id) const {
    const Entry* const entry = find(id);
    if (!entry) throw Failure("there is no entry {}", id);
    return *entry;
}

void Document::count_name(const Entry& entry, int by) {
    if (!entry.object() || entry.object()->name.empty()) return;
    int& count = names_[entry.object()->name];
    if ((count += by) == 0) names_.erase(entry.object()->name);
}

namespace {

uint64_t next_structure() {
    static uint64_t count = 0;
    return ++count;
}

}  // namespace

void Document::note_structure() {
    changes_.structure = true;
    structure_ = next_structure();
}

void Document::put(EntryId id, std::shared_ptr<Entry> entry) {
    Slot& slot = slots_[id];
    if (slot.entry) count_name(*slot.entry, -1);
    if (!slot.entry != !entry) {
        note_structure();
        count_ += entry ? 1 : -1;
    } else if (entry && slot.entry->name() != entry->name())
        structure_ = next_structure();
    if (slot.entry && entry && slot.entry != entry &&
        (slot.entry->parent != entry->parent || slot.entry->children != entry->children))
        note_structure();
    slot.entry = std::move(entry);
    if (slot.entry) count_name(*slot.entry, 1);
    note(id);
}

void Document::note(EntryId id) {
    if (!std::exchange(slots_[id].listed, true)) changes_.entries.push_back(id);
}

Document::Changes Document::take_changes() {
    for (const EntryId id : changes_.entries) slots_[id].listed = false;
    return std::exchange(changes_, {});
}

void Document::mark_all_changed() {
    changes_.structure = true;
    for (EntryId id = root_entry; id < slots_.size(); ++id) note(id);
}

// [steps]
void Document::begin(std::string name, uint64_t group) {
    if (open_) commit();
    open_ = Step{std::move(name), {group, 0}, {}, state_, state_};
}

// The first touch in a step keeps the old entry and continues with a copy.
Document::Slot& Document::touch(EntryId id) {
    if (!open_) throw Failure("the document is changed outside of a step");
    Slot& slot = slots_[id];
    note(id);
    if (std::exchange(slot.touched, true)) return slot;
    open_->kept.push_back({id, slot.entry, nullptr});
    if (slot.entry) slot.entry = std::make_shared<Entry>(*slot.entry);
    return slot;
}

bool Document::commit() {
    if (!open_) return false;
    Step step = *std::exchange(open_, std::nullopt);
    for (Kept& kept : step.kept) {
        Slot& slot = slots_[kept.id];
        slot.touched = false;
        kept.after = slot.entry;
        for (const auto& entry : {kept.before, kept.after})
            if (entry) step.size.bytes += bytes_of(*entry);
    }
    if (step.kept.empty()) return false;
    step.state_after = state_ = ++states_;
    std::vector<UndoSize> sizes;
    sizes.reserve(done_.size());
    for (const Step& one : done_) sizes.push_back(one.size);
    const Pushed pushed = push_step(sizes, step.size, !undone_.empty(), most_bytes);
    undone_.clear();
    if (pushed.joins && !done_.empty()) {
        Step last = std::move(done_.back());
        done_.pop_back();
        step = joined(std::move(last), std::move(step));
    }
    if (!step.kept.empty())
        done_.push_back(std::move(step));
    else
        state_ = step.state_before;
    for (uint32_t i = 0; i < pushed.forgotten && done_.size() > 1; ++i) done_.pop_front();
    return true;
}
// [/steps]

// Entries have numbers for the exercise; an unchanged entry has that of the one it equals.
Document::Step Document::joined(Step first, Step then) const {
    std::unordered_map<uint32_t, std::shared_ptr<Entry>> versions;
    std::unordered_map<const Entry*, uint32_t> numbers{{nullptr, 0}};
    const auto number = [&](const std::shared_ptr<Entry>& entry) {
        const auto [at, is_new] = numbers.try_emplace(entry.get(), static_cast<uint32_t>(numbers.size()));
        if (is_new) versions[at->second] = entry;
        return at->second;
    };
    std::unordered_map<EntryId, const Kept*> found;
    std::vector<Replaced> earlier, later;
    for (const Kept& kept : first.kept) {
        found[kept.id] = &kept;
        earlier.push_back({kept.id, number(kept.before), number(kept.after)});
    }
    for (const Kept& kept : then.kept) {
        const auto before = found.find(kept.id);
        const bool is_back = before != found.end() && kept.after && before->second->before &&
                             same_entry(*kept.after, *before->second->before);
        later.push_back({kept.id, number(kept.before), number(is_back ? before->second->before : kept.after)});
    }
    Step both{then.name, {then.size.group, 0}, {}, first.state_before, then.state_after};
    for (const Replaced& one : join_steps(earlier, later)) {
        both.kept.push_back({one.entry, versions[one.before], versions[one.after]});
        for (const auto& entry : {both.kept.back().before, both.kept.back().after})
            if (entry) both.size.bytes += bytes_of(*entry);
    }
    return both;
}

void Document::cancel() {
    if (!open_) return;
    const Step step = *std::exchange(open_, std::nullopt);
    for (auto kept = step.kept.rbegin(); kept != step.kept.rend(); ++kept) {
        put(kept->id, kept->before);
        slots_[kept->id].touched = false;
    }
}

// [undo]
bool Document::undo() {
    cancel();
    if (done_.empty()) return false;
    for (const Kept& kept : done_.back().kept) put(kept.id, kept.before);
    state_ = done_.back().state_before;
    undone_.push_back(std::move(done_.back()));
    done_.pop_back();
    return true;
}

bool Document::redo() {
    cancel();
    if (undone_.empty()) return false;
    for (const Kept& kept : undone_.back().kept) put(kept.id, kept.after);
    state_ = undone_.back().state_after;
    done_.push_back(std::move(undone_.back()));
    undone_.pop_back();
    return true;
}
// [/undo]

bool Document::take_back(uint64_t group) {
    if (done_.empty() || done_.back().size.group != group || !undo()) return false;
    undone_.pop_back();
    return true;
}

void Document::forget_steps() {
    done_.clear();
    undone_.clear();
}

std::vector<Document::Listed> Document::steps() const {
    std::vector<Listed> all;
    for (const Step& step : done_) all.push_back({step.name, step.size.bytes, false});
    for (auto step = undone_.rbegin(); step != undone_.rend(); ++step)
        all.push_back({step->name, step->size.bytes, true});
    return all;
}

uint64_t Document::bytes() const {
    uint64_t bytes = 0;
    for (const Step& step : done_) bytes += step.size.bytes;
    for (const Step& step : undone_) bytes += step.size.bytes;
    return bytes;
}

Entry& Document::edit(EntryId id) {
    at(id);
    return *touch(id).entry;
}

void Document::rename(EntryId id, const std::string& name) {
    Entry& entry = edit(id);
    count_name(entry, -1);
    if (entry.object()) entry.object()->name = name;
    if (entry.light()) entry.light()->name = name;
    count_name(entry, 1);
    structure_ = next_structure();
}

EntryId Document::add(EntryId parent, Entry entry, size_t place) {
    const EntryId id = static_cast<EntryId>(slots_.size());
    slots_.emplace_back();
    touch(id);
    entry.parent = parent;
    put(id, std::make_shared<Entry>(std::move(entry)));
    put_in({id}, parent, place);
    return id;
}

// Out of the lists of their parents, each of which is gone through once.
void Document::take_out(const std::vector<EntryId>& ids) {
    const std::unordered_set<EntryId> all(ids.begin(), ids.end());
    std::set<EntryId> parents;
    for (const EntryId id : ids) parents.insert(at(id).parent);
    for (const EntryId parent : parents) {
        std::vector<EntryId>& children = edit(parent).children;
        children_passed_ += children.size();
        std::erase_if(children, [&](EntryId child) { return all.contains(child); });
    }
}

void Document::put_in(const std::vector<EntryId>& ids, EntryId parent, size_t place) {
    std::vector<EntryId>& children = edit(parent).children;
    place = std::min(place, children.size());
    children_passed_ += ids.size() + children.size() - place;
    children.insert(children.begin() + static_cast<std::ptrdiff_t>(place), ids.begin(), ids.end());
}

void Document::remove(const std::vector<EntryId>& ids) {
    take_out(ids);
    for (const EntryId id : ids)
        for (const EntryId one : with_children(*this, id)) {
            touch(one);
            put(one, nullptr);
        }
}

void Document::move_below(const std::vector<EntryId>& ids, EntryId parent, size_t place) {
    take_out(ids);
    for (const EntryId id : ids) edit(id).parent = parent;
    put_in(ids, parent, place);
    note_structure();
}

void Document::order_children(EntryId parent, std::vector<EntryId> order) {
    children_passed_ += order.size();
    edit(parent).children = std::move(order);
    note_structure();
}

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
