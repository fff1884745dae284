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
    put(root_entry,
        std::make_shared<Entry>(
            Entry{.what = SceneSettings{scene.camera, scene.ambient, scene.background, scene.environment, scene.music,
                                        scene.knobs, scene.bare, scene.emission}}),
        ++versions_);
    count_ = 0;
    std::unordered_map<std::string, EntryId> by_name;
    const auto append = [&](EntryId parent, Entry entry) {
        const EntryId id = static_cast<EntryId>(slots_.size());
        slots_.emplace_back();
        entry.parent = parent;
        slots_[parent].entry->children.push_back(id);
        put(id, std::make_shared<Entry>(std::move(entry)), ++versions_);
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

void Document::put(EntryId id, std::shared_ptr<Entry> entry, uint32_t version) {
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
    slot.version = version;
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
    open_->kept.push_back({id, slot.entry, nullptr, slot.version, 0});
    if (slot.entry) slot.entry = std::make_shared<Entry>(*slot.entry);
    slot.version = ++versions_;
    return slot;
}

bool Document::commit() {
    if (!open_) return false;
    Step step = *std::exchange(open_, std::nullopt);
    for (Kept& kept : step.kept) {
        Slot& slot = slots_[kept.id];
        slot.touched = false;
        kept.after = slot.entry;
        kept.after_version = slot.entry ? slot.version : 0;
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

Document::Step Document::joined(Step first, Step then) const {
    std::unordered_map<uint32_t, std::shared_ptr<Entry>> versions;
    std::unordered_map<EntryId, const Kept*> found;
    for (const Kept& kept : first.kept) found[kept.id] = &kept;
    for (Kept& kept : then.kept) {  // unchanged entries are that version again
        const auto before = found.find(kept.id);
        if (before == found.end() || !kept.after || !before->second->before) continue;
        if (same_entry(*kept.after, *before->second->before)) kept.after_version = before->second->before_version;
    }
    const auto replaced = [](const Step& step) {
        std::vector<Replaced> all;
        for (const Kept& kept : step.kept) all.push_back({kept.id, kept.before_version, kept.after_version});
        return all;
    };
    for (const Step* step : {&first, &then})
        for (const Kept& kept : step->kept) {
            versions[kept.before_version] = kept.before;
            versions[kept.after_version] = kept.after;
        }
    versions[0] = nullptr;
    Step both{then.name, {then.size.group, 0}, {}, first.state_before, then.state_after};
    for (const Replaced& one : join_steps(replaced(first), replaced(then))) {
        both.kept.push_back({one.entry, versions[one.before], versions[one.after], one.before, one.after});
        for (const auto& entry : {both.kept.back().before, both.kept.back().after})
            if (entry) both.size.bytes += bytes_of(*entry);
    }
    return both;
}

void Document::cancel() {
    if (!open_) return;
    const Step step = *std::exchange(open_, std::nullopt);
    for (auto kept = step.kept.rbegin(); kept != step.kept.rend(); ++kept) {
        put(kept->id, kept->before, kept->before_version);
        slots_[kept->id].touched = false;
    }
}

// [undo]
bool Document::undo() {
    cancel();
    if (done_.empty()) return false;
    for (const Kept& kept : done_.back().kept) put(kept.id, kept.before, kept.before_version);
    state_ = done_.back().state_before;
    undone_.push_back(std::move(done_.back()));
    done_.pop_back();
    return true;
}

bool Document::redo() {
    cancel();
    if (undone_.empty()) return false;
    for (const Kept& kept : undone_.back().kept) put(kept.id, kept.after, kept.after_version);
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
    put(id, std::make_shared<Entry>(std::move(entry)), ++versions_);
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
            put(one, nullptr, 0);
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

}  // namespace lightwalk
