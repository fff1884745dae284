#include "19_ambiance/film_window.h"

#include <GLFW/glfw3.h>

#include <cmath>

#include "19_ambiance/timeline_edit.h"
#include "common/base/error.h"
#include "common/base/files.h"
#include "common/window/event_log.h"

namespace lightwalk {

// [steer]
// Requests by buttons and keys are served between two frames; a looped scene, and the film's end, are cuts as well.
void FilmWindow::steer(WindowClock& clock) {
    if (!reel.is_open()) return;
    if (wanted_) clock = *wanted_;
    wanted_.reset();
    // It stands at its end; played from there it begins again.
    if (const double end_s = reel.film().duration_s; clock.runs && double(clock.time_s) >= end_s) {
        const bool arrives = clock_.runs && double(clock_.time_s) < end_s;
        clock = {static_cast<float>(arrives ? end_s : 0.0), !arrives};
    }
    if (looped_ && clock.runs) {
        const FilmScene& again = reel.film().scenes.at(*looped_);
        const double time_s = double(clock.time_s);
        if (time_s < again.from_s || time_s >= again.to_s) {
            clock.time_s = static_cast<float>(again.from_s);
            log_event("loop again");
        }
    }
    if (clock.runs != clock_.runs) log_event(clock.runs ? "film plays" : "film stands");
    clock_ = clock;
    if (reel.fly && !flown_) take_off();
    if (!reel.fly || reel.scene_at(double(clock.time_s)) != flown_) land();
}
// [/steer]

void FilmWindow::set_time(double time_s, bool goes_on) {
    time_s = std::clamp(time_s, 0.0, reel.film().duration_s);
    wanted_ = {static_cast<float>(time_s), goes_on && clock_.runs};
    const auto on = reel.scene_at(time_s);
    log_event(fmt::format("film at {:.3f} s {}", time_s, on ? reel.film().scenes[*on].name : "black"));
}

// Frame n is at n / fps, as where the film is written.
void FilmWindow::step(int frames) {
    set_time((std::round(double(clock_.time_s) * double(out.fps)) + frames) * frame_s());
}

void FilmWindow::go_to_scene(int by) {
    const auto& scenes = reel.film().scenes;
    const double time_s = double(clock_.time_s);
    double to_s = by > 0 ? reel.film().duration_s : 0;
    for (const FilmScene& one : scenes)
        if (by > 0 ? one.from_s > time_s + 1e-3 : one.from_s < time_s - 1e-3) {
            to_s = one.from_s;
            if (by > 0) break;
        }
    set_time(to_s, true);
}

void FilmWindow::loop() {
    looped_ = looped_ ? std::nullopt : reel.scene_at(double(clock_.time_s));
    log_event(looped_ ? "loop " + reel.film().scenes[*looped_].name : "loop off");
}

// [fly]
// The camera continues from its position on the path. A manual step is a fraction of the viewing distance.
void FilmWindow::take_off() {
    const std::optional<Camera> from = reel.camera_at(double(clock_.time_s));
    if (!from) return;
    flown_ = reel.scene_at(double(clock_.time_s));
    reel.fly.value = true;
    camera = *from;
    const float around = 0.6f * glm::distance(from->position, from->target);
    scene.bounds = {from->target - around, from->target + around};
    log_event("fly " + reel.film().scenes[*flown_].name);
}
// [/fly]

void FilmWindow::land() {
    if (!flown_ && !reel.fly) return;
    flown_.reset();
    reel.fly.value = false;
    log_event("fly off");
}

template <class Edit>
void FilmWindow::edit(const char* what, const Edit& change) {
    const std::filesystem::path& file = reel.film().file;
    try {
        // The current file: edits made elsewhere meanwhile stay.
        const std::string text = read_file(file);
        parse_timeline(text, file);
        const std::string edited = change(text);
        const Timeline film = parse_timeline(edited, file);
        if (!reel.take_cameras(film)) throw InputError("{} has other scenes by now; F5 reads it again", file.string());
        write_file_to_disk(file, edited);
        notice_ = fmt::format("{} in {}", what, file.filename().string());
        log_event(fmt::format("{} at {:.3f} s", what, double(clock_.time_s)));
    } catch (const InputError& e) {
        notice_ = std::string("not written: ") + e.what();
        log_event("not written");
    }
}

// [place_key]
void FilmWindow::place_key() {
    const double time_s = double(clock_.time_s);
    const auto place = reel.scene_at(time_s);
    const std::optional<Camera> now = flown_ ? std::optional(camera) : reel.camera_at(time_s);
    if (!place || !now) return void(notice_ = "no scene is on: there is no camera to place");
    const FilmScene& shown = reel.film().scenes[*place];
    CameraKey key{.time_s = shown.clock_at(time_s), .position = now->position, .target = now->target, .up = now->up};
    // An angle only where the scene's keys have one: the others then keep the scene file's.
    if (!shown.camera.empty() && shown.camera.keys().front().fov_deg > 0)
        key.fov_deg = double(glm::degrees(now->fov_y_rad));
    edit("key placed", [&](const std::string& text) { return with_key(text, *place, key, 0.5 * frame_s()); });
    land();
}
// [/place_key]

void FilmWindow::remove_key() {
    const auto place = reel.scene_at(double(clock_.time_s));
    if (!place) return;
    const double at_s = reel.film().scenes[*place].clock_at(double(clock_.time_s));
    edit("key removed", [&](const std::string& text) { return without_key(text, *place, at_s, 0.5 * frame_s()); });
}

bool FilmWindow::on_save() {
    if (!reel.is_open()) return false;
    notice_ = "a key (K) is written into the film's file when it is placed";
    return true;
}

bool FilmWindow::on_key(const KeyPress& pressed) {
    if (!reel.is_open() || (pressed.mods & GLFW_MOD_CONTROL)) return false;
    const int frames = pressed.mods & GLFW_MOD_SHIFT ? static_cast<int>(std::lround(double(out.fps))) : 1;
    switch (pressed.key) {
        case GLFW_KEY_LEFT:
            step(-frames);
            return true;
        case GLFW_KEY_RIGHT:
            step(frames);
            return true;
        case GLFW_KEY_PAGE_UP:
            go_to_scene(-1);
            return true;
        case GLFW_KEY_PAGE_DOWN:
            go_to_scene(1);
            return true;
        case GLFW_KEY_L:
            loop();
            return true;
        case GLFW_KEY_C:
            flown_ ? land() : take_off();
            return true;
        case GLFW_KEY_K:
            place_key();
            return true;
        case GLFW_KEY_DELETE:
            remove_key();
            return true;
        case GLFW_KEY_T:
            shown_ = !shown_;
            return true;
        default:
            return false;
    }
}

}  // namespace lightwalk
