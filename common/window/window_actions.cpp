#include <GLFW/glfw3.h>

#include <algorithm>
#include <ctime>

#include "common/app/read_picture.h"
#include "common/base/error.h"
#include "common/base/exercise.h"
#include "common/base/files.h"
#include "common/study/method_choice.h"
#include "common/window/camera_control.h"
#include "common/window/event_log.h"
#include "common/window/window.h"

namespace lightwalk {
namespace {

namespace fs = std::filesystem;

constexpr float radians_per_pixel = 0.006f;
constexpr double notice_s = 5.0;

std::string time_stamp() {
    const std::time_t now = std::time(nullptr);
    char text[32];
    std::strftime(text, sizeof text, "%Y-%m-%d_%H%M%S", std::localtime(&now));
    return text;
}

// A second picture within a second does not replace the first.
fs::path unused(const std::string& stem, const std::string& extension) {
    fs::path path = stem + extension;
    for (int i = 2; fs::exists(path); ++i) path = stem + "_" + std::to_string(i) + extension;
    return path;
}

}  // namespace

void Window::handle_keys(const Input& input, Requests& requests) {
    const bool typing = ImGui::GetIO().WantTextInput;
    for (const auto& [key, mods] : input.pressed) {
        if (tool_ && !typing && tool_->on_key({key, mods})) {
            requests.changed = true;
            continue;
        }
        if (key == GLFW_KEY_F2) (mods & GLFW_MOD_SHIFT ? requests.earlier_toggles : requests.all_toggles) = true;
        if (key == GLFW_KEY_F3) requests.split = true;
        if (key == GLFW_KEY_F5) requests.reload = true;
        if (key == GLFW_KEY_F11) requests.capture = true;
        if (key == GLFW_KEY_F12) requests.screenshot = true;
        if (key == GLFW_KEY_S && (mods & GLFW_MOD_CONTROL)) requests.save = true;
        if (typing) continue;
        if (key == GLFW_KEY_ESCAPE) close_ = true;
        if (key == GLFW_KEY_F) requests.frame_scene = true;
        if (key == GLFW_KEY_HOME) requests.home = true;
        if (key == GLFW_KEY_H) requests.panel = true;
        if (key == GLFW_KEY_SPACE) requests.clock = true;
    }
}

void Window::obey(const Requests& requests) {
    if (requests.all_toggles || requests.earlier_toggles) toggle_all(requests.earlier_toggles);
    if (requests.reload) reload();
    if (requests.screenshot) take_screenshot();
    if (requests.capture) {
        capture_next_ = has_renderdoc();
        if (!capture_next_) tell("RenderDoc is not loaded: start with ENABLE_VULKAN_RENDERDOC_CAPTURE=1 ./course run");
    }
    if (requests.save) save_scene();
    if (requests.split) switch_split();
    if (requests.clock) clock_runs_ = !clock_runs_;
    if (requests.panel) panel_.visible = !panel_.visible;
    if (requests.home) chapter_.camera = chapter_.scene.file.camera;
    if (requests.frame_scene) {
        const glm::vec2 size(picture_size());
        CameraControl::frame(chapter_.camera, chapter_.scene.bounds, size.x / size.y);
    }
    if (!requests.lesson.empty()) tell(lessons_.open(requests.lesson));
    if (!requests.check.empty()) checks_.start(requests.check);
    const bool any = !requests.lesson.empty() || !requests.check.empty() || requests.all_toggles ||
                     requests.earlier_toggles || requests.reload || requests.screenshot || requests.capture ||
                     requests.save || requests.split || requests.clock || requests.panel || requests.home ||
                     requests.frame_scene || requests.changed;
    if (any) stay_active(0.3);
}

void Window::move_camera(const Input& input, double seconds) {
    Camera& camera = chapter_.camera;
    const ImGuiIO& io = ImGui::GetIO();
    const bool held = input.left || input.right || input.middle;
    // What began over the panel stays with it, what began over the picture with the camera.
    if (!held) dragging_ = false;
    if (tool_ && tool_has_mouse(input)) return;
    const float pixels_per_unit = static_cast<float>(display_.framebuffer_size().x) / float(display_.size().x);
    const bool over_picture = input.cursor.x * pixels_per_unit < static_cast<float>(picture_size().x);
    const bool was_dragging = dragging_;
    if (held && over_picture && !io.WantCaptureMouse) dragging_ = true;
    if (!held && over_picture && !io.WantCaptureMouse)
        follow_mouse(input.cursor * pixels_per_unit / glm::vec2(picture_size()));
    // The way to where the button went down is no drag: a frame that takes long reads both at once.
    if (was_dragging && dragging_ && glm::length(input.moved) > 0.0f) {
        const glm::vec2 turn = -radians_per_pixel * input.moved;
        const float height = static_cast<float>(display_.size().y);
        if (input.middle || (input.left && input.shift))
            CameraControl::pan(camera, input.moved, height);
        else if (input.left)
            CameraControl::orbit(camera, turn.x, -turn.y);
        else if (input.right)
            CameraControl::look(camera, turn.x, turn.y);
    }
    if (input.wheel != 0.0f && !io.WantCaptureMouse) CameraControl::zoom(camera, input.wheel, chapter_.scene.bounds);
    if (!dragging_ || !input.right) return;
    const auto axis = [&](int plus, int minus) {
        return static_cast<float>(display_.is_held(plus)) - static_cast<float>(display_.is_held(minus));
    };
    const glm::vec3 direction(axis(GLFW_KEY_D, GLFW_KEY_A), axis(GLFW_KEY_E, GLFW_KEY_Q), axis(GLFW_KEY_W, GLFW_KEY_S));
    if (direction == glm::vec3(0.0f)) return;
    const float speed = CameraControl::fly_speed(chapter_.scene.bounds) * (input.shift ? 5.0f : 1.0f);
    CameraControl::fly(camera, direction * (speed * static_cast<float>(seconds)));
    stay_active(0.1);
}

// While the camera is dragged the tool has nothing below the mouse, but is told of it: what has moved is no click.
bool Window::tool_has_mouse(const Input& input) {
    const float pixels_per_unit = static_cast<float>(display_.framebuffer_size().x) / float(display_.size().x);
    const glm::vec2 cursor = input.cursor * pixels_per_unit, size(picture_size());
    const bool over = cursor.x >= 0.0f && cursor.y >= 0.0f && cursor.x < size.x && cursor.y < size.y;
    const bool taken = tool_->on_mouse(input, cursor, over && !dragging_ && !ImGui::GetIO().WantCaptureMouse);
    return taken && !dragging_;
}

// What goes on beside the picture, and what it has to say.
void Window::ask_tool() {
    if (const auto files = display_.take_dropped(); !files.empty()) {
        tool_->on_drop(files);
        stay_active(0.3);
    }
    WindowClock clock{time_s_, clock_runs_};
    tool_->steer(clock);
    if (clock.time_s != time_s_ || clock.runs != clock_runs_) stay_active(0.3);
    time_s_ = clock.time_s, clock_runs_ = clock.runs;
    if (tool_->is_busy())
        active_until_ = std::max(active_until_, now() + 0.1);  // its panels say what changes the picture
    if (tool_->wants_to_close()) close_ = true;
    if (const std::string notice = tool_->take_notice(); !notice.empty()) {
        tell(notice);
        log_event("notice " + notice);
        active_until_ = std::max(active_until_, now() + 0.3);
    }
}

// Where something in the picture follows the mouse, the chapter has knobs of these names: 0 to 1 from the upper left
// corner.
void Window::follow_mouse(glm::vec2 place) {
    for (KnobBase* knob : chapter_.all_knobs())
        if (auto* number = dynamic_cast<Knob<float>*>(knob);
            number && (knob->name == "mouse_x" || knob->name == "mouse_y")) {
            const float before = number->value;
            number->value = std::clamp(knob->name == "mouse_x" ? place.x : place.y, 0.0f, 1.0f);
            if (number->value != before) stay_active(0.1);
        }
}

void Window::toggle_all(bool earlier_too) {
    auto ids = own_exercises(chapter_);
    if (earlier_too) {
        const auto earlier = earlier_exercises(chapter_);
        ids.insert(ids.end(), earlier.begin(), earlier.end());
    }
    if (!any_reference_exists(ids)) {
        tell("This tree is a handout: it has no reference to switch to.");
        return;
    }
    // A mixture becomes all reference first: from there each press changes everything.
    const bool solution = !all_reference(ids);
    for (const std::string& id : ids) Exercises::set(id, solution);
    tell(std::string(earlier_too ? "every exercise, earlier chapters' too: " : "every exercise: ") +
         (solution ? "reference" : "mine"));
    log_event(std::string("toggle all ") + (solution ? "reference" : "mine"));
}

void Window::reload() {
    gpu_.pipelines.rebuild();
    live_.reload();
    split_.reload();
    if (live_.load_error.empty()) remember_scene();
    tell(live_.load_error.empty() ? "reloaded" : "not reloaded");
    log_event("reloaded");
}

void Window::switch_split() {
    if (split_.on()) {
        split_.turn_off();
    } else if (!any_reference_exists(Exercises::ids())) {
        tell("This tree is a handout: there is no reference to show beside yours.");
    } else {
        try {
            split_.turn_on(chapter_);
        } catch (const std::exception& e) { tell(e.what()); }
    }
    log_event(split_.on() ? "split on" : "split off");
}

// The need rule measures what is drawn now, once: the method stays until another is chosen, whatever else changes.
void Window::choose_automatically() {
    KnobBase& method = find_knob(chapter_.all_knobs(), std::exchange(automatic_.wanted, ""));
    std::string line;
    try {
        const ToggleScope judges(Exercises::ids(), true);
        live_.follow_toggles();
        int pictures = 0;
        const double start = now();
        const auto cancelled = [&] {
            const Input input = display_.poll(0.0);
            return display_.wants_to_close() || std::any_of(input.pressed.begin(), input.pressed.end(),
                                                            [](auto& one) { return one.key == GLFW_KEY_ESCAPE; });
        };
        line = choose_method(chapter_, gpu_, method, double(automatic_.budget),
                             {picture_size(), time_s_, options_.seed, {}}, [&] {
                                 // The window draws nothing meanwhile, but its title can be read.
                                 display_.say(fmt::format("measuring {}: {} pictures, {:.0f} s (Esc cancels)",
                                                          method.path(), pictures++, now() - start));
                                 if (cancelled()) throw InputError(method.path() + ": not measured, cancelled by Esc");
                             });
        automatic_.chosen[method.path()] = {method.text(), line};
    } catch (const std::exception& e) { line = e.what(); }
    display_.say("");
    tell(line);
    log_event("auto " + line);
    stay_active(0.3);
}

void Window::write_capture(Capture& capture) {
    try {
        const fs::path path = unused("lightwalk_" + chapter_.name.substr(0, 2) + "_" + time_stamp(), ".rdc");
        capture.write(fs::absolute(path).string());
        tell("capture: " + fs::absolute(path).string());
        log_event("capture " + fs::absolute(path).string());
    } catch (const std::exception& e) { tell(e.what()); }
}

void Window::take_screenshot() {
    if (!shown_) return;
    try {
        const fs::path path = unused("lightwalk_" + chapter_.name.substr(0, 2) + "_" + time_stamp(), ".png");
        write_png(path, read_picture(gpu_, *shown_));
        tell("picture: " + fs::absolute(path).string());
        log_event("screenshot " + fs::absolute(path).string());
    } catch (const InputError& e) { tell(e.what()); }
}

// What the window changes is the camera and the knobs. A scene file of one's own keeps everything else; where it is not
// what was read, or another file is in the way, the key has to be pressed twice.
void Window::save_scene() {
    if (tool_ && tool_->on_save()) return;
    SceneFile scene = chapter_.scene.file;
    scene.camera = chapter_.camera;
    for (const KnobBase* knob : chapter_.all_knobs()) scene.knobs[knob->path()] = knob->text();
    const bool own =
        scene_.extension() == ".json" && fs::exists(scene_) && !lies_below(scene_, course_root() / "assets");
    const fs::path path = own ? scene_ : fs::path(chapter_.name.substr(0, 2) + "_scene.json");
    try {
        const uint64_t there = fs::exists(path) ? hash_bytes(read_file(path)) : 0;
        const bool known = there == 0 || there == (own ? scene_hash_ : saved_hash_);
        if (!known && now() > confirm_until_) {
            confirm_until_ = now() + notice_s;
            tell(path.string() + (own ? " was edited since it was read" : " is there already") +
                 "; Ctrl+S again writes " + (own ? "camera and knobs into it" : "over it"));
            log_event("asks before saving " + fs::absolute(path).string());
            return;
        }
        own ? update_scene(scene, path) : write_scene(scene, path);
        (own ? scene_hash_ : saved_hash_) = hash_bytes(read_file(path));
        confirm_until_ = 0;
        tell("scene: " + fs::absolute(path).string());
        log_event("saved " + fs::absolute(path).string());
    } catch (const InputError& e) {
        tell("not saved: " + std::string(e.what()));
        log_event("not saved");
    }
}

void Window::remember_scene() {
    std::error_code error;
    scene_hash_ = fs::is_regular_file(scene_, error) ? hash_bytes(read_file(scene_)) : 0;
}

void Window::tell(const std::string& text) {
    notice_ = text;
    notice_until_ = now() + notice_s;
}

}  // namespace lightwalk
