#include "18_playground/editor.h"

#include <fmt/core.h>

#include <algorithm>

#include "18_playground/gltf.h"
#include "common/base/error.h"
#include "common/base/files.h"
#include "common/scene/bare.h"

namespace lightwalk {

namespace {

// Of the editor itself, or of where the mouse is.
bool is_no_setting(const KnobBase& knob) {
    const std::string path = knob.path();
    return knob.name == "mouse_x" || knob.name == "mouse_y" || path.starts_with("marks.") ||
           path.starts_with("picker.") || path == "samples" || path == "select" || path == "show";
}

}  // namespace

void Editor::loaded(Chapter& chapter) {
    end_drag(true);  // the drag so far counts as a change
    // Another scene could not be loaded, and the previous one is shown again.
    if (std::exchange(shown_instances_, chapter.scene.instances.handle) == chapter.scene.instances.handle)
        return void(shown_ = &chapter.scene);
    // Toggles of exercises and F5 reload the window's first scene; the edited one may be another.
    const std::filesystem::path file = chapter.scene.file.file;
    const bool again = shown_ && !file.empty() && (file == first_file_ || file == store.path);
    const bool other = again && store.path != file;
    if (shown_ || first_file_.empty()) first_file_ = file;  // else it is open() that loads
    shown_ = &chapter.scene;
    if (again && (store.has_unsaved(document) || (!store.changed_on_disk() && !store.includes_changed_on_disk()))) {
        live = {};
        document.mark_all_changed();
        return;
    }
    const std::filesystem::path own = other ? store.path : file;
    first_knobs_.clear();
    for (const KnobBase* knob : chapter.all_knobs())
        if (!is_no_setting(*knob)) first_knobs_[knob->path()] = knob->text();
    known_knobs_ = first_knobs_;
    Document opened;
    try {
        opened = store.open(own);
    } catch (const InputError&) {  // a scene that is no file, as tests make them
        opened = Document(chapter.scene.file);
        store.open_empty();
    }
    if (own.extension() != ".json") opened = Document(chapter.scene.file);
    document = std::move(opened);
    selection.clear();
    drag.reset();
    if (!other) return live.begin(document, chapter.scene);
    live = {};
    document.mark_all_changed();
}

void Editor::open(Chapter& chapter, Gpu& gpu, const std::filesystem::path& file,
                  const std::function<void(Scene&)>& give) {
    Scene kept = std::exchange(chapter.scene, Scene());
    const Camera camera = chapter.camera;
    shown_ = nullptr;
    // The previous scene's settings do not carry over; those of the command line hold for all.
    std::vector<std::pair<KnobBase*, std::string>> knobs;
    for (KnobBase* knob : chapter.all_knobs())
        if (!is_no_setting(*knob) && !knob->pinned) {
            knobs.emplace_back(knob, knob->text());
            knob->reset();
        }
    try {
        if (give) give(chapter.scene);
        load_scene(chapter, gpu, file);
    } catch (...) {
        for (const auto& [knob, text] : knobs) knob->set(text);
        chapter.scene = std::move(kept);
        chapter.camera = camera;
        shown_ = &chapter.scene;
        chapter.prepare_all(gpu, chapter.scene);
        throw;
    }
}

void Editor::open_document(Chapter& chapter, Document next) {
    document = std::move(next);
    live = {};
    selection.clear();
    document.mark_all_changed();
    chapter.camera = document.settings().camera;
    chapter.forget_history();
    give_knobs(chapter);
}

void Editor::recover(Chapter& chapter) try {
    std::pair before(document, store);
    Said said;
    open_document(chapter, store.recover(&said));
    recovered_from_ = std::move(before);
    notice = said;
} catch (const InputError& e) { keep_recovery(e.what()); }

// Else the next autosave would write over it.
void Editor::keep_recovery(const std::string& why) {
    const std::filesystem::path kept = store.set_aside();
    notice = why + (kept.empty() ? "" : "; kept as " + kept.filename().string());
}

void Editor::take_knobs(const Chapter& chapter) {
    if (drag || chapter.tries_knobs) return;  // a drag's step is open
    std::map<std::string, std::string> changed;
    for (const KnobBase* knob : chapter.all_knobs()) {
        if (is_no_setting(*knob)) continue;
        const std::string text = knob->text();
        std::string& known = known_knobs_[knob->path()];
        if (known != text) changed[knob->path()] = known = text;
    }
    if (!changed.empty()) set_knobs(document, changed, gesture);
}

void Editor::give_knobs(Chapter& chapter) {
    const auto& wanted = document.settings().knobs;
    for (KnobBase* knob : chapter.all_knobs()) {
        const std::string path = knob->path();
        const auto first = first_knobs_.find(path);
        if (first == first_knobs_.end()) continue;
        const auto given = wanted.find(path);
        const std::string& value = given == wanted.end() ? first->second : given->second;
        if (known_knobs_[path] == value) continue;
        try {
            knob->set(value);
        } catch (const InputError& e) { notice = e.what(); }
        known_knobs_[path] = knob->text();
    }
}

bool Editor::update(Chapter& chapter, Gpu& gpu) {
    loads = false;
    if (!shown_) return false;
    take_knobs(chapter);
    const auto loader = [&](const std::filesystem::path& file) { return chapter.load_model(file); };
    try {
        const bool replaced = live.update(gpu, document, chapter.scene, loader);
        loads = live.loads;
        shown_instances_ = chapter.scene.instances.handle;
        recovered_from_.reset();
        if (replaced) without_.clear();
        return replaced;
    } catch (const InputError& e) { return show_without(chapter, gpu, e.what()); }
}

// Without the last step, is everything readable that was not with it? Then that step is undone. Else the files have changed
// since, and the picture is drawn without them.
bool Editor::show_without(Chapter& chapter, Gpu& gpu, const std::string& why) {
    const auto show = [&](std::vector<std::string>& without) {
        without.clear();
        document.mark_all_changed();
        const bool replaced = live.update(
            gpu, document, chapter.scene, [&](const auto& file) { return chapter.load_model(file); }, &without);
        loads |= live.loads;
        shown_instances_ = chapter.scene.instances.handle;
        return replaced;
    };
    std::vector<std::string> without, earlier;
    if (auto before = std::exchange(recovered_from_, std::nullopt)) {
        store = std::move(before->second);
        open_document(chapter, std::move(before->first));
        keep_recovery(why);
        return show(without);
    }
    bool replaced = show(without);
    const bool undone = document.undo();
    if (undone) replaced = show(earlier);
    const auto known = [&](const std::string& one) { return std::count(earlier.begin(), earlier.end(), one) > 0; };
    const auto fault = std::find_if_not(without.begin(), without.end(), known);
    if (undone && fault != without.end()) {
        notice = *fault;
    } else {
        if (undone) {
            document.redo();
            replaced = show(without);
        }
        if (without_ != without && !without.empty()) notice = without.front() + "; drawn without it";
        without_ = without;
    }
    selection.drop_missing(document);
    return replaced;
}

bool Editor::undo(Chapter& chapter) {
    end_drag(false);
    const std::string* const name = document.next_undo();
    if (!name) return false;
    std::string what = "undone: " + *name;
    document.undo();
    follow_steps(chapter, std::move(what));
    return true;
}

bool Editor::redo(Chapter& chapter) {
    end_drag(false);
    const std::string* const name = document.next_redo();
    if (!name) return false;
    std::string what = "done again: " + *name;
    document.redo();
    follow_steps(chapter, std::move(what));
    return true;
}

void Editor::go_to(Chapter& chapter, size_t done) {
    end_drag(false);
    const size_t before = document.done();
    while (document.done() > done && document.undo()) {}
    while (document.done() < done && document.redo()) {}
    const size_t now = document.done();
    if (now < before) follow_steps(chapter, fmt::format("undone: {} steps", before - now));
    if (now > before) follow_steps(chapter, fmt::format("done again: {} steps", now - before));
}

void Editor::follow_steps(Chapter& chapter, std::string what) {
    notice = std::move(what);
    selection.drop_missing(document);
    give_knobs(chapter);
}

void Editor::save(const Chapter& chapter, const std::filesystem::path& as) {
    store.camera = chapter.camera;
    const Said said = as.empty() ? store.save(document) : store.save_as(document, as);
    notice = "saved " + std::filesystem::absolute(store.path).string() + (said.empty() ? "" : "; " + said);
}

void Editor::begin_drag(const GizmoPlace& place, const Handle& handle, const View& view, glm::vec2 cursor_px) {
    drag.emplace(document, selection.ids, place, handle, view, cursor_px);
}

void Editor::end_drag(bool keep) {
    if (!drag) return;
    if (keep)
        drag->finish();
    else
        drag->cancel();
    drag.reset();
}

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
