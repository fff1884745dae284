#include "common/window/window.h"

#include <chrono>
#include <optional>
#include <utility>

#include "common/base/error.h"
#include "common/base/exercise.h"
#include "common/study/method_choice.h"
#include "common/window/blit.h"
#include "common/window/event_log.h"
#include "common/window/titles.h"

namespace lightwalk {
namespace {

// An editor that opens a file to write it has written it after this.
constexpr std::chrono::milliseconds writing{50};

constexpr double watch_every_s = 0.2;  // how often shader files are looked at
constexpr double settle_s = 0.2;       // drawn for so long after something happened, for the panel to come to rest
constexpr int settle_frames = 6;       // and at least so many: a field that is asked for has the keyboard in the fifth
constexpr double compare_every_s = 1.0;  // while the picture moves
constexpr glm::ivec2 default_size{1480, 660};

}  // namespace

int run_window(const Options& options, Chapter& chapter, std::unique_ptr<Gpu>& holder, const MakeChapter& make,
               const Loading& loading) {
    // With --size the picture has that size, as it has without a window.
    const std::filesystem::path scene = options.scene.empty() ? chapter.default_scene() : options.scene;
    find_asset(scene);  // a wrong name is said even where there is no display
    const glm::ivec2 size =
        options.size_given ? glm::ivec2(options.size) + glm::ivec2(Panel::default_width, 0) : default_size;
    Display display("Lightwalk " + chapter.name.substr(0, 2) + " · " + chapter_title(chapter.name), size,
                    "without one: --screenshot FILE writes the picture");
    holder = std::make_unique<Gpu>(DeviceOptions{
        .name = options.device, .validate = options.validate, .surface_extensions = Display::surface_extensions()});
    Gpu& gpu = *holder;
    gpu.pipelines.keep_last_good = true;
    LiveChapter live(chapter, gpu, scene);
    live.load(loading);
    Window(options, live, gpu, display, make, scene).run();
    gpu.device.check_validation();
    return 0;
}

Window::Window(const Options& options, LiveChapter& live, Gpu& gpu, Display& display, const MakeChapter& make,
               std::filesystem::path scene)
    : options_(options),
      live_(live),
      chapter_(live.chapter),
      tool_(dynamic_cast<WindowTool*>(&live.chapter)),
      gpu_(gpu),
      display_(display),
      scene_(std::move(scene)),
      swapchain_(gpu, display),
      overlay_(gpu, display, swapchain_),
      panel_(chapter_, overlay_),
      split_(gpu, make, scene_),
      frame_(gpu),
      screen_(gpu),
      clock_runs_(chapter_.any_animated()),
      time_s_(options.time_s) {
    look_.output = options.look;
    if (options.budget) automatic_.budget = static_cast<float>(*options.budget);
    for (const KnobBase* knob : chapter_.all_knobs())
        if (dynamic_cast<const Choice*>(knob) && !study_of(chapter_, *knob).empty())
            automatic_.offered.insert(knob->path());
        else if (dynamic_cast<const Choice*>(knob) && knob->name == "method")
            automatic_.without.insert(knob->path());
    if (tool_) tool_->automatic = &automatic_;
    remember_scene();
}

double Window::now() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

glm::uvec2 Window::picture_size() const {
    const uint32_t panel = static_cast<uint32_t>(panel_.width(display_.scale(), swapchain_.size.x));
    return {std::max(swapchain_.size.x - std::min(panel, swapchain_.size.x), 16u), swapchain_.size.y};
}

void Window::run() {
    stay_active(settle_s);
    for (;;) {
        if (display_.wants_to_close() || close_) {
            if (!tool_ || tool_->may_close()) break;
            display_.stay_open();
            close_ = false;
            stay_active(settle_s);
        }
        if (tool_) ask_tool();
        // Nothing is drawn while nothing changes: a software rasteriser has better things to do.
        const bool idle = is_still();
        if (std::exchange(rests_, idle) != idle && idle) log_event("rests");
        const Input input = display_.poll(idle || !swapchain_.ready() ? watch_every_s : 0.0);
        Requests requests;
        handle_keys(input, requests);
        obey(requests);
        note_acts(input);
        watch_files();
        watch_programs();
        if (!swapchain_.ready()) continue;
        compare_when_still();
        if (!notice_.empty() && now() > notice_until_) {
            notice_.clear();
            active_until_ = now() + 0.01;
        }
        const Sound* sound = clock_runs_ ? chapter_.any_sound() : nullptr;
        // Music does not wait for a picture that takes long; without it, the clock of one that does goes slower.
        const double since_last = std::min(now() - last_draw_, sound ? 1.0 : 0.1);
        move_camera(input, since_last);
        time_s_ = static_cast<float>(sound_.advance(sound, double(time_s_), clock_runs_, since_last));
        if (!automatic_.wanted.empty() && drawn_ > asked_auto_ + 1) choose_automatically();  // the notice is to be seen
        if (is_still()) continue;
        draw();
    }
}

// A picture takes a software rasteriser much longer than the panel. The mouse on its way changes none; what is done to the
// panel does where the panel says so, and one more is drawn when all is done.
void Window::note_acts(const Input& input) {
    if (!input.happened) return;
    active_until_ = std::max(active_until_, now() + settle_s), frames_due_ = settle_frames;
    if (!input.acted) return;
    const ImGuiIO& io = ImGui::GetIO();
    last_picture_due_ = true;
    if (!io.WantCaptureMouse && !io.WantTextInput) picture_due_ = true;
}

void Window::stay_active(double seconds) {
    active_until_ = std::max(active_until_, now() + seconds);
    picture_due_ = last_picture_due_ = true;
}

bool Window::has_settled() const { return now() > active_until_ && frames_due_ == 0 && !overlay_.input_is_left(); }

// What moves may show what was there a frame before (screens in screens): more pictures are drawn of it.
bool Window::picture_is_due() const {
    return clock_runs_ || picture_due_ || (last_picture_due_ && (has_settled() || chapter_.any_animated())) ||
           capture_next_ || !shown_ || drawn_size_ != picture_size();
}

bool Window::is_still() const { return !clock_runs_ && !last_picture_due_ && has_settled(); }

void Window::watch_files() {
    if (now() < next_watch_) return;
    next_watch_ = now() + watch_every_s;
    if (!gpu_.pipelines.forget_changed_files(writing)) return;
    log_event("reloaded shaders");
    stay_active(settle_s);
}

void Window::watch_programs() {
    if (checks_.poll()) stay_active(settle_s);
    if (const std::string wrong = lessons_.poll(); !wrong.empty()) {
        tell(wrong);
        stay_active(settle_s);
    }
}

Requests Window::build_panel(bool picture_is_new) {
    overlay_.begin();
    PanelState state{.chapter = chapter_,
                     .device = gpu_.device,
                     .split = split_,
                     .look = look_,
                     .checks = checks_,
                     .automatic = automatic_,
                     .outputs = Look::names(frame_),
                     .times = frame_.times,
                     .picture_is_new = picture_is_new,
                     .frame_ms = frame_ms_,
                     .clock_runs = clock_runs_,
                     .time_s = time_s_,
                     .picture = picture_size()};
    const std::string asked_before = automatic_.wanted;
    Requests requests = panel_.draw(state, display_.scale());
    const float covered = tool_ ? tool_->covered_px(picture_size(), display_.scale()) : 0.0f;
    panel_.draw_messages(errors(), notice_, picture_size(), covered);
    if (split_.on() && panel_.draw_divider(split_, picture_size())) requests.changed = true;
    if (tool_ && tool_->draw_panels(picture_size(), display_.scale())) requests.changed = true;
    if (automatic_.wanted != asked_before) {
        asked_auto_ = drawn_;
        tell("measuring the methods of " + automatic_.wanted + " ... (Esc cancels)");
        requests.changed = true;
    }
    overlay_.end();
    return requests;
}

std::vector<std::string> Window::errors() {
    std::vector<std::string> all;
    for (const auto& [pipeline, error] : gpu_.pipelines.errors) all.push_back(error);
    for (const std::string& error : {live_.load_error, live_.frame_error, split_.error()})
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

void Window::draw_picture(glm::uvec2 size) {
    picture_due_ = false;
    if (has_settled()) last_picture_due_ = false;
    drawn_size_ = size;
    shown_ = nullptr;
    compared_ = false;
    gpu_.pipelines.errors.clear();
    look_.attach(frame_, viewed_, chapter_.camera, chapter_.scene.bounds);
    {
        // Where every switch says reference, two equal halves would show nothing: the left one is then mine.
        const auto own = own_exercises(chapter_);
        std::optional<ToggleScope> mine;
        if (split_.on() && all_reference(own)) mine.emplace(own, false);
        std::optional<Capture> capture;
        if (std::exchange(capture_next_, false)) capture.emplace();
        live_.draw(frame_, {size, time_s_, options_.seed, {}});
        if (capture) write_capture(*capture);
    }
    if (split_.on()) split_.draw(chapter_, look_, {size, time_s_, options_.seed, {}});
}

void Window::draw() {
    frames_due_ = std::max(frames_due_ - 1, 0);
    const glm::uvec2 size = picture_size();
    const double started = now();
    const bool anew = picture_is_due();
    if (anew) draw_picture(size);
    const Requests requests = build_panel(anew);

    const Image* target = swapchain_.acquire();
    if (target) {
        screen_.begin({1, 1}, time_s_);
        const Image& mine = look_.picture(frame_, viewed_);
        const Image& picture = split_.on() ? compose(size, mine, split_.picture(look_)) : mine;
        shown_ = &picture;
        screen_.transfer("present", {.reads = {picture}, .writes = {*target}}, [&](VkCommandBuffer commands) {
            const Area shown{{0, 0}, glm::min(size, target->desc.size)};
            blit(commands, picture, shown, *target, shown);
        });
        screen_.transfer("panel", {}, [&](VkCommandBuffer commands) { overlay_.draw(commands); });
        screen_.end(swapchain_.acquired(), swapchain_.rendered());
        swapchain_.present();
        if (++drawn_ == 1) log_event("first picture");
    }
    log_frame(overlay_.input_is_left(), anew);
    const double ended = now();
    const double milliseconds = 1e3 * (ended - started);
    if (anew) frame_ms_ += (drawn_ < 3 ? 1.0 : 0.1) * (milliseconds - frame_ms_);
    last_draw_ = started;
    obey(requests);
}

const Image& Window::compose(glm::uvec2 size, const Image& mine, const Image& reference) {
    if (composed_.desc.size != size || !composed_)
        composed_ = Image(gpu_.device, {.name = "composed", .format = VK_FORMAT_R8G8B8A8_UNORM, .size = size});
    const uint32_t left = std::min(static_cast<uint32_t>(split_.divider * static_cast<float>(size.x)), size.x);
    screen_.transfer("compose", {.reads = {mine, reference}, .writes = {composed_}}, [&](VkCommandBuffer commands) {
        const Area left_side{{0, 0}, {left, size.y}}, right_side{{left, 0}, {size.x - left, size.y}};
        blit(commands, mine, left_side, composed_, left_side);
        blit(commands, reference, right_side, composed_, right_side);
    });
    return composed_;
}

void Window::compare_when_still() {
    if (!split_.drawn() || !frame_.output) return;
    if (split_.poll()) {
        log_event("flip " + std::to_string(split_.difference->flip_mean));
        active_until_ = now() + 0.01;  // to show the figure
    }
    const bool still = is_still();
    const bool due = clock_runs_ && now() > next_compare_;
    if (compared_ || !(still || due)) return;
    split_.compare(look_.picture(frame_, viewed_), split_.picture(look_));
    next_compare_ = now() + compare_every_s;
    compared_ = true;
}

}  // namespace lightwalk
