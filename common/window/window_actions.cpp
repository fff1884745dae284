#include <GLFW/glfw3.h>

#include <algorithm>
#include <ctime>

#include "common/app/read_picture.h"
#include "common/base/error.h"
#include "common/base/exercise.h"
#include "common/base/files.h"
#include "common/base/own_files.h"
#include "common/study/need.h"
#include "common/window/camera_control.h"
#include "common/window/event_log.h"
#include "common/window/window.h"

namespace lightwalk {

namespace {

namespace fs = std::filesystem;

std::string time_stamp() {
    const std::time_t now = std::time(nullptr);
    char text[32];
    std::strftime(text, sizeof text, "%Y-%m-%d_%H%M%S", std::localtime(&now));
    return text;
}

// A second picture within a second does not replace the first.
fs::path unused(const std::string& name, const std::string& extension) {
    const std::string stem = (saving_folder() / name).string();
    fs::path path = stem + extension;
    for (int i = 2; fs::exists(path); ++i) path = stem + "_" + std::to_string(i) + extension;
    return path;
}

}  // namespace

void Window::handle_keys(const Input& input, Requests& requests) {
    const bool typing = ImGui::GetIO().WantTextInput;
    for (const auto& [key, mods] : input.pressed) {
        if (key == GLFW_KEY_ESCAPE && !typing && close_popup()) continue;
        if (key == GLFW_KEY_ESCAPE && !typing && keyboard_marks()) {
            leave_keyboard();
            continue;
        }
        if (tool_ && !typing && tool_->on_key({key, mods})) {
            requests.changed = true;
            continue;
        }
        if (key == GLFW_KEY_F2) (mods & GLFW_MOD_SHIFT ? requests.earlier_toggles : requests.all_toggles) = true;
        if (key == GLFW_KEY_F3) requests.split = true;
        if (key == GLFW_KEY_F5) requests.reload = true;
        if (key == GLFW_KEY_F6) requests.passes = true;
        if (key == GLFW_KEY_F11) requests.capture = true;
        if (key == GLFW_KEY_F12) requests.screenshot = true;
        if (key == GLFW_KEY_S && (mods & GLFW_MOD_CONTROL)) requests.save = true;
        if (typing) continue;
        if (key == GLFW_KEY_ESCAPE) close_ = true;
        if (key == GLFW_KEY_F) requests.frame_scene = true;
        if (key == GLFW_KEY_HOME) requests.home = true;
        if (key == GLFW_KEY_H) requests.panel = true;
        if (key == GLFW_KEY_SPACE && !keyboard_marks()) requests.clock = true;
    }
}

void Window::obey(const Requests& requests) {
    if (requests.all_toggles || requests.earlier_toggles) toggle_all(requests.earlier_toggles);
    if (requests.reload) reload();
    if (requests.screenshot) take_screenshot();
    if (requests.capture) {
        capture_next_ = has_renderdoc();
        if (!capture_next_)
            notice_.tell("RenderDoc is not loaded: start with ENABLE_VULKAN_RENDERDOC_CAPTURE=1 ./course run");
    }
    if (requests.save && !(tool_ && tool_->on_save())) saver_.save();
    if (requests.split) switch_split();
    if (requests.clock) clock_.runs = !clock_.runs;
    if (requests.passes) picture_.graph.show(!picture_.graph.shown());
    if (requests.panel) panel_.visible = !panel_.visible;
    if (requests.home) chapter_.camera = chapter_.scene.file.camera;
    if (requests.frame_scene) {
        const glm::vec2 size(picture_size());
        CameraControl::frame(chapter_.camera, chapter_.scene.bounds, size.x / size.y);
    }
    if (!requests.lesson.empty()) notice_.tell(lessons_.open(requests.lesson));
    if (!requests.check.empty()) checks_.start(requests.check);
    const bool any = !requests.lesson.empty() || !requests.check.empty() || requests.all_toggles ||
                     requests.earlier_toggles || requests.reload || requests.screenshot || requests.capture ||
                     requests.save || requests.split || requests.clock || requests.panel || requests.passes ||
                     requests.home || requests.frame_scene || requests.changed;
    if (any) activity_.stay(0.3);
}

// Runs the tool's background work and takes its messages.
void Window::ask_tool() {
    if (const auto files = display_.take_dropped(); !files.empty()) {
        tool_->on_drop(files);
        activity_.stay(0.3);
    }
    const WindowClock before = clock_;
    tool_->steer(clock_);
    if (clock_.time_s != before.time_s || clock_.runs != before.runs) activity_.stay(0.3);
    if (tool_->is_busy()) activity_.stay_panel(0.1);  // its panels report changes of the picture
    if (tool_->wants_to_close()) close_ = true;
    display_.name_document(tool_->document());
    if (const std::string notice = tool_->take_notice(); !notice.empty()) {
        notice_.tell(notice);
        log_event("notice " + notice);
        activity_.stay_panel(0.3);
    }
}

void Window::toggle_all(bool earlier_too) {
    auto ids = own_exercises(chapter_);
    if (earlier_too) {
        const auto earlier = earlier_exercises(chapter_);
        ids.insert(ids.end(), earlier.begin(), earlier.end());
    }
    if (!any_reference_exists(ids)) {
        notice_.tell("This tree is a handout: it has no reference to switch to.");
        return;
    }
    // A mixture becomes all reference first: from there each press changes everything.
    const bool solution = !all_reference(ids);
    for (const std::string& id : ids) Exercises::set(id, solution);
    notice_.tell(std::string(earlier_too ? "every exercise, earlier chapters' too: " : "every exercise: ") +
                 (solution ? "reference" : "mine"));
    log_event(std::string("toggle all ") + (solution ? "reference" : "mine"));
}

void Window::reload() {
    gpu_.pipelines.rebuild();
    live_.reload();
    picture_.split.reload();
    if (live_.load_error.empty()) saver_.remember();
    notice_.tell(live_.load_error.empty() ? "reloaded" : "not reloaded");
    log_event("reloaded");
}

void Window::switch_split() {
    if (picture_.split.on()) {
        picture_.split.turn_off();
    } else if (!any_reference_exists(Exercises::ids())) {
        notice_.tell("This tree is a handout: there is no reference to show beside yours.");
    } else {
        try {
            picture_.split.turn_on(chapter_);
        } catch (const std::exception& e) { notice_.tell(e.what()); }
    }
    log_event(picture_.split.on() ? "split on" : "split off");
}

// The need rule measures the current picture once: the method stays until another is chosen.
void Window::choose_automatically() {
    KnobBase& method = find_knob(chapter_.all_knobs(), std::exchange(automatic_.wanted, ""));
    std::string line;
    try {
        const ToggleScope judges(Exercises::ids(), true);
        live_.follow_toggles();
        int pictures = 0;
        const double start = steady_s();
        const auto cancelled = [&] {
            const Input input = display_.poll(0.0);
            return display_.wants_to_close() || std::any_of(input.pressed.begin(), input.pressed.end(),
                                                            [](auto& one) { return one.key == GLFW_KEY_ESCAPE; });
        };
        line = choose_method(chapter_, gpu_, method, double(automatic_.budget),
                             {picture_size(), clock_.time_s, options_.seed, {}}, [&] {
                                 // The window draws nothing meanwhile, but its title can be read.
                                 display_.say(fmt::format("measuring {}: {} pictures, {:.0f} s (Esc cancels)",
                                                          method.path(), pictures++, steady_s() - start));
                                 if (cancelled()) throw InputError(method.path() + ": not measured, cancelled by Esc");
                             });
        automatic_.chosen[method.path()] = {method.text(), line};
    } catch (const std::exception& e) { line = e.what(); }
    display_.say("");
    notice_.tell(line);
    log_event("auto " + line);
    activity_.stay(0.3);
}

void Window::write_capture(Capture& capture) {
    try {
        const fs::path path = unused("lightwalk_" + chapter_.name.substr(0, 2) + "_" + time_stamp(), ".rdc");
        capture.write(fs::absolute(path).string());
        notice_.tell("capture: " + fs::absolute(path).string());
        log_event("capture " + fs::absolute(path).string());
    } catch (const std::exception& e) { notice_.tell(e.what()); }
}

void Window::take_screenshot() {
    if (!picture_.shown()) return;
    try {
        const fs::path path = unused("lightwalk_" + chapter_.name.substr(0, 2) + "_" + time_stamp(), ".png");
        write_png(path, read_picture(gpu_, *picture_.shown()));
        notice_.tell("picture: " + fs::absolute(path).string());
        log_event("screenshot " + fs::absolute(path).string());
    } catch (const InputError& e) { notice_.tell(e.what()); }
}

SceneSaver::SceneSaver(const Chapter& chapter, fs::path scene, Notice& notice)
    : chapter_(chapter), scene_(std::move(scene)), notice_(notice) {
    remember();
}

void SceneSaver::save() {
    SceneFile scene = chapter_.scene.file;
    scene.camera = chapter_.camera;
    for (const KnobBase* knob : chapter_.all_knobs()) scene.knobs[knob->path()] = knob->text();
    const bool own =
        scene_.extension() == ".json" && fs::exists(scene_) && !lies_below(scene_, course_root() / "assets");
    const fs::path path = own ? scene_ : saving_folder() / (chapter_.name.substr(0, 2) + "_scene.json");
    try {
        const uint64_t there = fs::exists(path) ? hash_bytes(read_file(path)) : 0;
        const bool known = there == 0 || there == (own ? read_ : saved_);
        if (!known && steady_s() > confirm_until_) {
            confirm_until_ = steady_s() + Notice::shown_s;
            notice_.tell(path.string() + (own ? " was edited since it was read" : " is there already") +
                         "; Ctrl+S again writes " + (own ? "camera and knobs into it" : "over it"));
            log_event("asks before saving " + fs::absolute(path).string());
            return;
        }
        own ? update_scene(scene, path) : write_scene(scene, path);
        (own ? read_ : saved_) = hash_bytes(read_file(path));
        confirm_until_ = 0;
        notice_.tell("scene: " + fs::absolute(path).string());
        log_event("saved " + fs::absolute(path).string());
    } catch (const InputError& e) {
        notice_.tell("not saved: " + std::string(e.what()));
        log_event("not saved");
    }
}

void SceneSaver::remember() {
    std::error_code error;
    read_ = fs::is_regular_file(scene_, error) ? hash_bytes(read_file(scene_)) : 0;
}

}  // namespace lightwalk
