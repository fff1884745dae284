#include "common/window/window.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <optional>
#include <utility>

#include "common/base/error.h"
#include "common/base/exercise.h"
#include "common/base/preparing.h"
#include "common/study/need.h"
#include "common/window/blit.h"
#include "common/window/event_log.h"
#include "common/window/lesson_pages.h"
#include "common/window/overlay.h"

namespace lightwalk {

namespace {

// An editor that opens a file to write it has written it after this.
constexpr std::chrono::milliseconds writing{50};

constexpr double watch_every_s = 0.2;  // how often shader files are looked at
constexpr double late_after_s = 1.0;   // of a picture
constexpr glm::ivec2 default_size{1480, 720};

// A dock in the window `beside` the panel, or none where it would take most of the picture.
uint32_t dock_px(const WindowTool* tool, float scale, uint32_t beside) {
    const float wanted = tool ? static_cast<float>(tool->dock_width()) * scale : 0.0f;
    return wanted < 0.6f * static_cast<float>(beside) ? static_cast<uint32_t>(wanted) : 0;
}

}  // namespace

int run_window(const Options& options, Chapter& chapter, std::unique_ptr<Gpu>& holder, const MakeChapter& make,
               const Loading& loading) {
    // With --size the picture has that size, as it has without a window.
    const std::filesystem::path scene = options.scene.empty() ? chapter.default_scene() : options.scene;
    chapter.scene_is_given = !options.scene.empty();
    find_asset(scene);  // a wrong name is said even where there is no display
    const auto* const tool = dynamic_cast<const WindowTool*>(&chapter);
    const glm::ivec2 panels(Panel::default_width + (tool ? tool->dock_width() : 0), StatusLine::height);
    const WindowSize size =
        options.size_given ? WindowSize{panels, glm::ivec2(options.size)} : WindowSize{.scaled = default_size};
    Display display("Lightwalk " + chapter.name.substr(0, 2) + " · " + chapter_title(chapter.name), size,
                    "./course run " + chapter.name.substr(0, 2) + " --screenshot picture.png");
    holder = std::make_unique<Gpu>(
        DeviceOptions{.name = options.device,
                      .validate = options.validate,
                      .software_paths = options.software_paths,
                      .surface_extensions = Display::surface_extensions(),
                      .presents = [&display](VkInstance instance, VkPhysicalDevice physical, uint32_t queue_family) {
                          return display.takes(instance, physical, queue_family);
                      }});
    Gpu& gpu = *holder;
    gpu.pipelines.keep_last_good = true;
    PreparingTitle preparing(display);
    LiveChapter live(chapter, gpu, scene);
    live.load(loading);
    Window(options, live, gpu, display, make, scene, preparing).run();
    gpu.device.check_validation();
    return 0;
}

PreparingTitle::PreparingTitle(Display& display) : display_(display) {
    on_preparing() = [this](const std::string& what) {
        if (steady_s() < late_s_) return;
        display_.say("preparing " + what);
        log_event("preparing " + what);
        said_ = true;
    };
}

PreparingTitle::~PreparingTitle() { on_preparing() = nullptr; }

void PreparingTitle::begin_picture() {
    if (!said_) late_s_ = steady_s() + late_after_s;
}

void PreparingTitle::end_picture() {
    if (std::exchange(said_, false)) display_.say("");
}

Window::Window(const Options& options, LiveChapter& live, Gpu& gpu, Display& display, const MakeChapter& make,
               std::filesystem::path scene, PreparingTitle& preparing)
    : options_(options),
      live_(live),
      chapter_(live.chapter),
      tool_(dynamic_cast<WindowTool*>(&live.chapter)),
      gpu_(gpu),
      display_(display),
      preparing_(preparing),
      swapchain_(gpu, display),
      overlay_(gpu, display, swapchain_),
      activity_(overlay_),
      saver_(chapter_, scene, notice_),
      mouse_(chapter_, display_, activity_),
      panel_(chapter_, overlay_),
      picture_(live, gpu, make, std::move(scene), options.seed),
      screen_(gpu),
      clock_{options.time_s, chapter_.any_animated()} {
    picture_.look.output = options.look;
    if (options.budget) automatic_.budget = static_cast<float>(*options.budget);
    for (const KnobBase* knob : chapter_.all_knobs())
        if (dynamic_cast<const Choice*>(knob) && !study_of(chapter_, *knob).empty())
            automatic_.offered.insert(knob->path());
        else if (dynamic_cast<const Choice*>(knob) && knob->name == "method")
            automatic_.without.insert(knob->path());
    if (tool_)
        tool_->automatic = &automatic_;
    else
        enable_keyboard();
}

Area Window::picture_area() const {
    const glm::uvec2 whole = swapchain_.size;
    const float scale = display_.scale();
    const auto panel = static_cast<uint32_t>(panel_.width(scale, whole.x));
    const uint32_t beside = whole.x - std::min(panel, whole.x), dock = dock_px(tool_, scale, beside);
    const uint32_t below = StatusLine::height_px(scale, whole.y) + picture_.graph.height_px(scale, whole.y);
    return {{dock, 0}, glm::max(glm::uvec2(beside - dock, whole.y - below), 16u)};
}

glm::vec2 Window::on_picture(glm::vec2 cursor) const {
    return cursor * display_.pixels_per_unit() - glm::vec2(picture_area().corner);
}

void Window::run() {
    activity_.stay(Activity::settle_s);
    for (;;) {
        if (display_.wants_to_close() || close_) {
            if (!tool_ || tool_->may_close()) break;
            display_.stay_open();
            close_ = false;
            activity_.stay(Activity::settle_s);
        }
        if (tool_) ask_tool();
        // Nothing is drawn while nothing changes: a software rasteriser has better things to do.
        const bool idle = is_still();
        if (std::exchange(rests_, idle) != idle && idle) log_event("rests");
        const Input input = display_.poll(idle || !can_show() ? watch_every_s : 0.0);
        Requests requests;
        handle_keys(input, requests);
        obey(requests);
        activity_.note(input);
        watch_files();
        watch_programs();
        if (!can_show()) continue;
        compare_when_still();
        if (notice_.has_ended()) activity_.stay_panel(0.01);
        const Sound* sound = clock_.runs ? chapter_.any_sound() : nullptr;
        // Music does not wait for a picture that takes long; without it, the clock of one that does goes slower.
        const double since_last = std::min(steady_s() - last_draw_, sound ? 1.0 : 0.1);
        cursor_ = on_picture(input.cursor);
        mouse_.move(input, cursor_, picture_size(), since_last);
        clock_.time_s = static_cast<float>(sound_.advance(sound, double(clock_.time_s), clock_.runs, since_last));
        if (!automatic_.wanted.empty() && drawn_ > automatic_.asked_at + 1)
            choose_automatically();  // the notice is to be seen
        if (is_still()) continue;
        draw();
        rests_ = false;  // to be said again, also where this frame was the only one
    }
}

bool Window::can_show() {
    if (swapchain_.is_outdated()) screen_.finish();
    return swapchain_.ready();
}

bool Window::picture_is_due() const {
    return clock_.runs || activity_.picture_is_due(chapter_.any_animated()) || capture_next_ ||
           !picture_.has(picture_size());
}

bool Window::is_still() const { return !clock_.runs && activity_.is_still() && !refines(); }

bool Window::refines() const {
    return options_.refine && !tool_ && activity_.is_still() && !picture_is_due() && logged_errors_.empty() &&
           picture_.can_refine();
}

void Window::watch_files() {
    if (steady_s() < next_watch_) return;
    next_watch_ = steady_s() + watch_every_s;
    if (!gpu_.pipelines.forget_changed_files(writing)) return;
    log_event("reloaded shaders");
    activity_.stay(Activity::settle_s);
}

void Window::watch_programs() {
    if (checks_.poll()) activity_.stay(Activity::settle_s);
    if (const std::string wrong = lessons_.poll(); !wrong.empty()) {
        notice_.tell(wrong);
        activity_.stay(Activity::settle_s);
    }
}

Requests Window::build_panel(bool picture_is_new) {
    overlay_.begin();
    PanelState state{.chapter = chapter_,
                     .device = gpu_.device,
                     .split = picture_.split,
                     .look = picture_.look,
                     .checks = checks_,
                     .automatic = automatic_,
                     .outputs = Look::names(picture_.frame()),
                     .times = picture_.frame().times,
                     .picture_is_new = picture_is_new,
                     .frame_ms = frame_ms_,
                     .clock_runs = clock_.runs,
                     .time_s = clock_.time_s,
                     .picture = picture_size(),
                     .errors = errors()};
    const std::string asked_before = automatic_.wanted;
    Requests requests = panel_.draw(state, display_.scale());
    const Area area = picture_area();
    panel_.draw_errors_instead(state, area, display_.scale());
    if (picture_.split.on() && panel_.draw_divider(picture_.split, area)) requests.changed = true;
    const float scale = display_.scale(), dock = static_cast<float>(area.corner.x);
    if (tool_ && tool_->draw_panels(area, dock, scale)) requests.changed = true;
    draw_status();
    const uint32_t graph_px = picture_.graph.height_px(scale, swapchain_.size.y);
    const Area room{{area.corner.x, swapchain_.size.y - graph_px}, {area.size.x, graph_px}};
    if (picture_.graph.draw(room, scale, picture_.frame(), picture_.look)) requests.changed = true;
    if (automatic_.wanted != asked_before) {
        automatic_.asked_at = drawn_;
        notice_.tell("measuring the methods of " + automatic_.wanted + " ... (Esc cancels)");
        requests.changed = true;
    }
    overlay_.end();
    return requests;
}

void Window::draw_status() {
    const Area area = picture_area();
    const bool free = !ImGui::GetIO().WantCaptureMouse && !ImGui::IsAnyMouseDown();
    const bool over = free && glm::all(glm::greaterThanEqual(cursor_, glm::vec2(0.0f))) &&
                      glm::all(glm::lessThan(cursor_, glm::vec2(area.size)));
    probe_.look(gpu_, picture_.frame(), chapter_, over ? std::optional(glm::uvec2(cursor_)) : std::nullopt);
    StatusLine::draw(area, display_.scale(), notice_.text(), tool_ ? tool_->mouse_words() : std::vector<std::string>(),
                     probe_.words());
}

std::vector<std::string> Window::errors() {
    std::vector<std::string> all;
    for (const auto& [pipeline, error] : gpu_.pipelines.errors) all.push_back(error);
    for (const std::string& error : {live_.load_error, live_.frame_error, picture_.split.error()})
        if (!error.empty()) all.push_back(error);
    std::string joined;
    for (const std::string& error : all) joined += "error: " + error + "\n";
    if (joined != logged_errors_) {
        logged_errors_ = joined;
        log_event(joined.empty() ? "no error" : joined.substr(0, joined.size() - 1));
        if (!joined.empty()) std::fprintf(stderr, "%s", joined.c_str());
    }
    return all;
}

void Window::draw_picture() {
    activity_.begin_picture();
    if (picture_.refined > 0) display_.say("");
    std::function<void(Capture&)> captured;
    if (std::exchange(capture_next_, false)) captured = [this](Capture& capture) { write_capture(capture); };
    preparing_.begin_picture();
    picture_.draw(picture_size(), clock_.time_s, captured);
    preparing_.end_picture();
}

void Window::draw() {
    activity_.begin_panel();
    const double started = steady_s();
    const bool anew = picture_is_due();
    // What is clicked or asked for arrives with the picture; only a clock that runs draws another one.
    const size_t in_flight = clock_.runs && !picture_.split.on() ? 2 : 1;
    picture_.set_frames_in_flight(in_flight);
    screen_.set_frames_in_flight(in_flight);
    if (anew) {
        draw_picture();
    } else if (refines()) {
        picture_.refine(clock_.time_s);
        display_.say(fmt::format("{} of {} samples", picture_.refined, WindowPicture::most_samples));
    }
    const Requests requests = build_panel(anew);

    const Image* target = swapchain_.acquire();
    if (target) {
        screen_.begin({1, 1}, clock_.time_s);
        const Image& picture = picture_.show(screen_);
        screen_.transfer("present", {.reads = {picture}, .writes = {*target}}, [&](VkCommandBuffer commands) {
            const glm::uvec2 corner = picture_area().corner,
                             size = glm::min(picture.desc.size, target->desc.size - corner);
            blit(commands, picture, {{0, 0}, size}, *target, {corner, size});
        });
        if (picture_.graph.has_images())
            screen_.transfer("passes", {.reads = {picture_.graph.images()}, .writes = {*target}},
                             [&](VkCommandBuffer commands) { picture_.graph.blit_to(commands, *target); });
        screen_.transfer("panel", {}, [&](VkCommandBuffer commands) { overlay_.draw(commands); });
        screen_.end(swapchain_.acquired(), swapchain_.rendered());
        swapchain_.present();
        if (++drawn_ == 1) log_event("first picture");
    }
    log_frame(overlay_.input_is_left(), anew);
    const double ended = steady_s();
    const double milliseconds = 1e3 * (ended - started);
    if (anew) frame_ms_ += (drawn_ < 3 ? 1.0 : 0.1) * (milliseconds - frame_ms_);
    last_draw_ = started;
    obey(requests);
}

void Window::compare_when_still() {
    if (!picture_.compare(is_still(), clock_.runs)) return;
    log_event("flip " + std::to_string(picture_.split.difference->flip_mean));
    activity_.stay_panel(0.01);  // to show the figure
}

namespace {

const std::vector<std::string> camera_words{"drag: orbit", "wheel: zoom", "Shift+drag: pan",
                                            "right button + WASD QE: fly"};
const std::vector<std::string> pixel_words{"point at the picture: object, material, linear colour, depth"};

// Whole words only, from the first on.
void draw_words(const std::vector<std::string>& words, float right) {
    const float gap = 2.0f * ImGui::GetStyle().ItemSpacing.x;
    float used = ImGui::GetCursorPosX();
    for (size_t i = 0; i < words.size(); ++i) {
        const float width = ImGui::CalcTextSize(words[i].c_str()).x;
        if (used + width > right) break;
        if (i > 0) ImGui::SameLine(0.0f, gap);
        ImGui::TextUnformatted(words[i].c_str());
        log_place("status." + words[i]);
        used += width + gap;
    }
}

}  // namespace

uint32_t StatusLine::height_px(float scale, uint32_t window_height) {
    const float wanted = static_cast<float>(height) * scale;
    return wanted < 0.2f * static_cast<float>(window_height) ? static_cast<uint32_t>(wanted) : 0;
}

void StatusLine::draw(const Area& picture, float scale, const std::string& notice,
                      const std::vector<std::string>& mouse, const std::vector<std::string>& pixel) {
    const float top = static_cast<float>(picture.corner.y + picture.size.y), width = static_cast<float>(picture.size.x);
    const auto below = static_cast<float>(height_px(scale, static_cast<uint32_t>(ImGui::GetIO().DisplaySize.y)));
    const float padding = ImGui::GetStyle().WindowPadding.x, right = width - padding;
    const float lines = notice.empty() ? 0.0f : ImGui::CalcTextSize(notice.c_str(), nullptr, false, right - padding).y;
    const float high = std::max(below, lines > 0.0f ? lines + 4.0f * scale : 0.0f);
    if (high < 1.0f) return;
    ImGui::SetNextWindowPos({static_cast<float>(picture.corner.x), top + below - high});
    ImGui::SetNextWindowSize({width, high});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0.0f);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {padding, 2.0f * scale});
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ImGui::GetStyle().ItemSpacing.x, 1.0f});
    ImGui::Begin("status", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoFocusOnAppearing |
                     ImGuiWindowFlags_NoBringToFrontOnFocus);
    if (notice.empty()) {
        ImGui::PushStyleColor(ImGuiCol_Text, quiet_color);
        draw_words(mouse.empty() ? camera_words : mouse, right);
        ImGui::PopStyleColor();
    } else {
        ImGui::PushTextWrapPos(right);
        ImGui::TextUnformatted(notice.c_str());
        ImGui::PopTextWrapPos();
        log_place("notice");
    }
    if (lines < 1.5f * ImGui::GetTextLineHeight()) {
        ImGui::PushStyleColor(ImGuiCol_Text, pixel.empty() ? quiet_color : ImGui::GetStyleColorVec4(ImGuiCol_Text));
        draw_words(pixel.empty() ? pixel_words : pixel, right);
        ImGui::PopStyleColor();
    }
    ImGui::End();
    ImGui::PopStyleVar(3);
}

}  // namespace lightwalk
