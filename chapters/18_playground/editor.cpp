#include "18_playground/editor.h"

#include <fmt/core.h>

#include <algorithm>

#include "common/base/error.h"
#include "common/base/files.h"

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
    seen_knobs_.clear();
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
    if (seen_knobs_.empty())
        for (const KnobBase* knob : chapter.all_knobs())
            if (!is_no_setting(*knob)) seen_knobs_.push_back({knob, {}, {}});
    std::map<std::string, std::string> changed;
    for (SeenKnob& seen : seen_knobs_) {
        const KnobBase::Numbers now = seen.knob->numbers();
        if (seen.variant == seen.knob->variant() && std::ranges::equal(seen.numbers, now)) continue;
        seen.variant = seen.knob->variant();
        seen.numbers = now;
        const std::string text = seen.knob->text();
        std::string& known = known_knobs_[seen.knob->path()];
        if (known != text) changed[seen.knob->path()] = known = text;
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

// [update]
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
// [/update]

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
    notice = "saved " + store.path.string() + (said.empty() ? "" : "; " + said);
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

}  // namespace lightwalk
