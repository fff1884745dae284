#include "19_ambiance/film_window.h"

#include <GLFW/glfw3.h>

#include <cmath>

#include "19_ambiance/timeline.h"
#include "common/base/error.h"
#include "common/base/files.h"
#include "common/window/event_log.h"
#include "common/window/overlay.h"
#include "common/window/panel.h"

namespace lightwalk {

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

namespace {

constexpr float golden_ratio = 0.618034f;

ImU32 color_of(size_t scene, float value) {
    const float hue = std::fmod(0.58f + golden_ratio * float(scene), 1.0f);
    return ImGui::ColorConvertFloat4ToU32(ImColor::HSV(hue, 0.45f, value));
}

bool button(const char* label, const char* name, const char* help, bool pressed = false) {
    if (pressed) ImGui::PushStyleColor(ImGuiCol_Button, ImVec4{0.24f, 0.47f, 0.70f, 1.0f});
    const bool clicked = ImGui::Button(label);
    if (pressed) ImGui::PopStyleColor();
    log_place(std::string("strip.") + name);
    help_on_hover(help);
    ImGui::SameLine();
    return clicked;
}

}  // namespace

struct FilmWindow::Bar {
    ImDrawList& draw;
    ImVec2 low, high;  ///< its corners
    double duration_s;

    float x(double time_s) const { return low.x + float(time_s / duration_s) * (high.x - low.x); }
    double time_s(float x) const { return double((x - low.x) / (high.x - low.x)) * duration_s; }
    float y(float share) const { return low.y + share * (high.y - low.y); }  ///< from above
};

bool FilmWindow::draw_panels(const Area& picture, float, float scale) {
    if (!reel.is_open() || !shown_) return false;
    const bool asked = wanted_.has_value();
    const float height = 116.0f * scale, width = float(picture.size.x);
    ImGui::SetNextWindowPos({0.0f, float(picture.size.y) - height});
    ImGui::SetNextWindowSize({width, height});
    ImGui::SetNextWindowBgAlpha(0.9f);
    ImGui::Begin("timeline", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoNav);
    draw_buttons();
    const ImVec2 size{std::max(ImGui::GetContentRegionAvail().x, 16.0f), ImGui::GetContentRegionAvail().y};
    ImGui::InvisibleButton("bar", size);
    log_place("strip.bar");
    const Bar bar{*ImGui::GetWindowDrawList(), ImGui::GetItemRectMin(), ImGui::GetItemRectMax(),
                  reel.film().duration_s};
    scrub(bar);
    draw_names(bar);
    draw_scenes(bar);
    draw_music(bar);
    draw_fades(bar);
    draw_keys(bar);
    draw_head(bar);
    ImGui::End();
    return asked || wanted_.has_value();
}

void FilmWindow::draw_buttons() {
    if (button("|<", "previous", "Page up: the beginning of the scene, or of the one before")) go_to_scene(-1);
    if (button("<", "back", "Left: a frame back; Shift: a second")) step(-1);
    if (button(clock_.runs ? "Stop" : "Play", "play", "Space"))
        wanted_ = {wanted_.value_or(clock_).time_s, !clock_.runs};
    if (button(">", "forward", "Right: a frame on; Shift: a second")) step(1);
    if (button(">|", "next", "Page down: the next scene")) go_to_scene(1);
    if (button("Loop", "loop", "L: this scene again and again", looped_.has_value())) loop();
    if (button(flown_ ? "Land" : "Fly", "fly", "C: the camera by hand, as in every chapter, or back on its path",
               flown_.has_value()))
        flown_ ? land() : take_off();
    if (button("Key", "key", "K: the camera as it is now becomes a key of the scene's path, in the film's file"))
        place_key();
    const double time_s = double(clock_.time_s);
    const auto on = reel.scene_at(time_s);
    ImGui::Text("%6.2f s   frame %ld   %s", time_s, std::lround(time_s * double(out.fps)),
                on ? reel.film().scenes[*on].name.c_str() : "");
}

void FilmWindow::scrub(const Bar& bar) {
    if (ImGui::IsItemActive()) {
        if (!std::exchange(scrubs_, true)) ran_ = clock_.runs;
        scrubbed_s_ = std::clamp(bar.time_s(ImGui::GetIO().MousePos.x), 0.0, bar.duration_s);
        wanted_ = {static_cast<float>(scrubbed_s_), false};
    } else if (std::exchange(scrubs_, false)) {
        set_time(scrubbed_s_);
        wanted_->runs = ran_;
    }
}

// Each scene as a block; where two overlap the later one comes in along a slope.
void FilmWindow::draw_scenes(const Bar& bar) const {
    const std::vector<FilmScene>& scenes = reel.film().scenes;
    const float top = bar.y(0.08f), bottom = bar.y(0.52f), pad = 4.0f;
    bar.draw.AddRectFilled(bar.low, {bar.high.x, bottom}, IM_COL32(8, 9, 11, 255));
    for (size_t i = 0; i < scenes.size(); ++i) {
        const bool fades_in = i > 0 && scenes[i - 1].to_s > scenes[i].from_s;
        const float left = bar.x(scenes[i].from_s), right = bar.x(scenes[i].to_s) - 1.0f;
        const float in = fades_in ? bar.x(scenes[i - 1].to_s) : left;
        const bool is_on = clock_.time_s >= float(scenes[i].from_s) && clock_.time_s < float(scenes[i].to_s);
        bar.draw.AddQuadFilled({left, bottom}, {in, top}, {right, top}, {right, bottom},
                               color_of(i, is_on ? 0.80f : 0.48f));
        const std::string label = cut_text(scenes[i].name, right - in - 2.0f * pad, ".");
        bar.draw.PushClipRect({in, top}, {right, bottom}, true);
        bar.draw.AddText({in + pad, top + 2.0f}, IM_COL32(255, 255, 255, 235), label.c_str());
        bar.draw.PopClipRect();
        if (looped_ == i) bar.draw.AddRect({left, top}, {right, bottom}, IM_COL32(255, 255, 255, 255), 0.0f, 0, 2.0f);
    }
}

// The scenes below the pointer, by their whole names.
void FilmWindow::draw_names(const Bar& bar) const {
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    if (!ImGui::IsItemHovered() || mouse.y > bar.y(0.52f)) return;
    const double time_s = bar.time_s(mouse.x);
    ImGui::BeginTooltip();
    for (const FilmScene& one : reel.film().scenes)
        if (one.from_s <= time_s && time_s < one.to_s) {
            ImGui::Text("%s: %.1f to %.1f s", one.name.c_str(), one.from_s, one.to_s);
            log_place("strip.name." + one.name);
        }
    ImGui::EndTooltip();
}

// How loud the music is, as far as its levels are known.
void FilmWindow::draw_music(const Bar& bar) const {
    const float bottom = bar.y(0.86f), most = bottom - bar.y(0.56f);
    for (float x = bar.low.x; x < bar.high.x; x += 2.0f) {
        const Levels levels = reel.music.levels(bar.time_s(x));
        bar.draw.AddLine({x, bottom}, {x, bottom - most * levels.w}, IM_COL32(110, 128, 150, 255));
        bar.draw.AddLine({x, bottom}, {x, bottom - most * levels.w * levels.x}, IM_COL32(190, 150, 90, 255));
    }
}

// The extent of fades, over the scenes: dark or bright.
void FilmWindow::draw_fades(const Bar& bar) const {
    for (float x = bar.low.x; x < bar.high.x; x += 1.0f) {
        const Timeline::Faded faded = reel.film().faded(bar.time_s(x));
        const float most = std::max(faded.black, faded.white);
        if (most <= 0) continue;
        const int code = faded.white >= faded.black ? 255 : 0;
        bar.draw.AddLine({x, bar.y(0.08f)}, {x, bar.y(0.52f)}, IM_COL32(code, code, code, int(200.0f * most)));
    }
}

void FilmWindow::draw_keys(const Bar& bar) const {
    const float y = bar.y(0.44f), r = 4.0f;
    for (const FilmScene& shown : reel.film().scenes)
        for (const CameraKey& key : shown.camera.keys()) {
            const float x = bar.x(shown.from_s + key.time_s - shown.clock_s);
            bar.draw.AddQuadFilled({x, y - r}, {x + r, y}, {x, y + r}, {x - r, y}, IM_COL32(255, 236, 170, 255));
        }
}

void FilmWindow::draw_head(const Bar& bar) const {
    for (double tick_s = 0; tick_s <= bar.duration_s; tick_s += 10) {
        const bool is_minute = std::fmod(tick_s, 60.0) < 1;
        const float x = bar.x(tick_s);
        bar.draw.AddLine({x, bar.y(is_minute ? 0.86f : 0.93f)}, {x, bar.high.y}, IM_COL32(150, 158, 170, 255));
    }
    const float x = bar.x(double(clock_.time_s));
    bar.draw.AddLine({x, bar.low.y}, {x, bar.high.y}, IM_COL32(255, 255, 255, 255), 2.0f);
    bar.draw.AddTriangleFilled({x - 6.0f, bar.low.y}, {x + 6.0f, bar.low.y}, {x, bar.low.y + 8.0f},
                               IM_COL32(255, 255, 255, 255));
}

}  // namespace lightwalk
