#include "common/window/live_chapter.h"

#include <algorithm>
#include <utility>

#include "common/base/error.h"
#include "common/base/exercise.h"

namespace lightwalk {

LiveChapter::LiveChapter(Chapter& c, Gpu& gpu, std::filesystem::path scene)
    : chapter(c), gpu_(gpu), scene_(std::move(scene)) {}

void LiveChapter::load(const Loading& loading) {
    chapter.plays = true;
    loaded_with_ = chapter.load_state();
    try {
        load_scene(chapter, gpu_, scene_, loading);
        loaded_with_ = chapter.load_state();  // the need rule may have set a knob that loading depends on
    } catch (const std::exception& e) {
        if (!chapter.loads_exercise()) throw;
        load_error = e.what();
        const ToggleScope reference(Exercises::ids(), true);
        chapter.scene = Scene();
        load_scene(chapter, gpu_, scene_, loading);
    }
}

void LiveChapter::reload() {
    loaded_with_ = chapter.load_state();
    const Camera camera = chapter.camera;
    const KnobList knobs = chapter.all_knobs();
    std::vector<std::string> settings;
    std::vector<bool> pinned;  // modules load what knobs say now, not what the scene says
    for (KnobBase* knob : knobs) {
        settings.push_back(knob->text());
        pinned.push_back(std::exchange(knob->pinned, true));
    }
    Scene kept = std::exchange(chapter.scene, Scene());
    try {
        load_scene(chapter, gpu_, scene_);
        load_error.clear();
    } catch (const std::exception& e) {
        load_error = e.what();
        chapter.scene = std::move(kept);
        chapter.prepare_all(gpu_, chapter.scene);
    }
    chapter.camera = camera;
    for (size_t i = 0; i < settings.size(); ++i) {
        knobs[i]->pinned = pinned[i];
        if (knobs[i]->text() != settings[i]) knobs[i]->set(settings[i]);
    }
}

void LiveChapter::draw(Frame& frame, const Picture& picture) {
    follow_toggles();
    frame_error.clear();
    try {
        render(chapter, frame, picture);
    } catch (const std::exception& e) { frame_error = e.what(); }
}

namespace {

std::vector<std::string> exercises_where(const std::function<bool(std::string_view number)>& is_asked) {
    std::vector<std::string> result = Exercises::ids();
    std::erase_if(result, [&](const std::string& id) { return !is_asked(std::string_view(id).substr(0, 2)); });
    return result;
}

}  // namespace

std::vector<std::string> own_exercises(const Chapter& chapter) {
    return exercises_where([&](std::string_view number) { return number == chapter.name.substr(0, 2); });
}

std::vector<std::string> earlier_exercises(const Chapter& chapter) {
    return exercises_where([&](std::string_view number) { return number < chapter.name.substr(0, 2); });
}

bool all_reference(const std::vector<std::string>& ids) {
    return std::all_of(ids.begin(), ids.end(), Exercises::uses_solution);
}

bool any_reference_exists(const std::vector<std::string>& ids) {
    return std::any_of(ids.begin(), ids.end(), Exercises::has_solution);
}

}  // namespace lightwalk
