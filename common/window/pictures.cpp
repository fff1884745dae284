#include "common/window/pictures.h"

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <iostream>
#include <list>
#include <nlohmann/json.hpp>

#include "common/app/headless.h"
#include "common/app/look.h"
#include "common/app/read_picture.h"
#include "common/base/error.h"
#include "common/base/exercise.h"
#include "common/image/decode.h"
#include "common/window/camera_control.h"
#include "common/window/live_chapter.h"

namespace lightwalk {
namespace {

using nlohmann::json;
using Words = std::vector<std::string>;

constexpr size_t most_warm = 3;     // a page shows several pictures of a chapter
constexpr int most_frames = 16;     // of a shot that lets its picture settle
constexpr int moving_quality = 85;  // of a JPEG

// A loaded command line, and its state before requests changed it.
struct Warm {
    Words words;
    std::unique_ptr<Chapter> chapter;
    Options options;
    std::unique_ptr<LiveChapter> live;
    std::unique_ptr<Frame> frame;
    Image looked_at;
    Camera camera;
    Words settings;  // of all knobs
};

class Pictures {
  public:
    Pictures(std::string name, const MakeChapter& make, std::unique_ptr<Gpu>& gpu)
        : name_(std::move(name)), make_(make), holder_(gpu), gpu_(*gpu) {}

    // The answer; a live picture goes into `bytes`.
    json answer(const json& request, std::string& bytes);

  private:
    std::optional<Options> read(Words words, std::unique_ptr<Chapter>& chapter) const;
    void draw_file(const Words& words);
    json draw_live(const json& request, std::string& bytes);
    Warm& find(const Words& words);
    void turn(Warm& warm, const json& request) const;
    std::string name_;
    const MakeChapter& make_;
    std::unique_ptr<Gpu>& holder_;
    Gpu& gpu_;
    std::list<std::unique_ptr<Warm>> warm_;  // the last one used first
    std::string before_key_;                 // of the last file's scene
    Scene before_;
};

// The options of a command line, and a new chapter that has its knobs.
std::optional<Options> Pictures::read(Words words, std::unique_ptr<Chapter>& chapter) const {
    chapter = make_();
    chapter->name = name_;
    words.insert(words.begin(), name_);
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    return read_options(static_cast<int>(arguments.size()), arguments.data(), *chapter);
}

// Dependencies of a loaded scene. A scene file rewritten between two pictures counts as another; models and textures
// it names are kept while a list is drawn.
std::string load_key(const Options& options, const Chapter& chapter) {
    namespace fs = std::filesystem;
    std::string key = options.scene + " " + chapter.load_state();
    if (!options.shot.empty() || options.scene.empty()) return key;
    std::error_code error;
    const auto written = fs::last_write_time(options.scene, error).time_since_epoch().count();
    return fmt::format("{} {} {}", key, written, fs::file_size(options.scene, error));
}

void Pictures::draw_file(const Words& words) {
    std::unique_ptr<Chapter> chapter;
    auto options = read(words, chapter);
    if (!options || options->screenshot.empty() || options->automatic)
        throw InputError("a picture of a list has a --screenshot, and no --method auto");
    options->pictures = true;
    const std::string key = load_key(*options, *chapter);
    if (key == before_key_) chapter->scene = std::move(before_);
    before_key_.clear();
    before_ = {};
    run_headless(*options, *chapter, holder_, {});
    before_key_ = key;
    before_ = std::move(chapter->scene);
}

Warm& Pictures::find(const Words& words) {
    const auto known = std::ranges::find_if(warm_, [&](const auto& one) { return one->words == words; });
    if (known != warm_.end()) {
        warm_.splice(warm_.begin(), warm_, known);
        return *warm_.front();
    }
    while (warm_.size() >= most_warm) warm_.pop_back();
    auto warm = std::make_unique<Warm>();
    auto options = read(warm->words = words, warm->chapter);
    if (!options || options->automatic || options->headless() || options->command)
        throw InputError("\"words\" name a scene or a shot, knobs and a size");
    warm->options = std::move(*options);
    Chapter& chapter = *warm->chapter;
    const std::string& scene = warm->options.scene;
    warm->live = std::make_unique<LiveChapter>(chapter, gpu_, scene.empty() ? chapter.default_scene() : scene);
    warm->live->load();
    warm->frame = std::make_unique<Frame>(gpu_);
    warm->camera = chapter.camera;
    for (const KnobBase* knob : chapter.all_knobs()) warm->settings.push_back(knob->text());
    warm_.push_front(std::move(warm));
    return *warm_.front();
}

// The size asked for, or the words' own.
glm::uvec2 size_of(const json& request, const Options& options) {
    if (!request.contains("size")) return options.size;
    const glm::uvec2 size{request["size"].at(0).get<unsigned>(), request["size"].at(1).get<unsigned>()};
    if (std::min(size.x, size.y) < 16 || std::max(size.x, size.y) > 2048)
        throw InputError("\"size\": expected two numbers, each from 16 to 2048");
    return size;
}

// Applies knobs and camera, always starting from the loaded state: a request is complete in itself.
void Pictures::turn(Warm& warm, const json& request) const {
    Chapter& chapter = *warm.chapter;
    const KnobList knobs = chapter.all_knobs();
    std::map<const KnobBase*, std::string> wanted;
    const json set = request.value("set", json::object());
    for (const auto& [name, value] : set.items())
        wanted[&find_knob(knobs, name == "method" ? chapter.method_knob : name)] =
            value.is_string() ? value.get<std::string>() : value.dump();
    for (size_t i = 0; i < knobs.size(); ++i) {
        const auto asked = wanted.find(knobs[i]);
        const std::string& text = asked == wanted.end() ? warm.settings[i] : asked->second;
        if (knobs[i]->text() != text) knobs[i]->set(text);
    }
    Camera& camera = chapter.camera = warm.camera;
    const float turn_rad = request.value("turn_rad", 0.0f), tilt_rad = request.value("tilt_rad", 0.0f);
    if (turn_rad != 0 || tilt_rad != 0) CameraControl::orbit(camera, turn_rad, tilt_rad);
    if (const float notches = request.value("notches", 0.0f); notches != 0)
        CameraControl::zoom(camera, notches, chapter.scene.bounds);
    if (request.contains("pan"))
        CameraControl::pan(camera, {request["pan"].at(0).get<float>(), request["pan"].at(1).get<float>()}, 1.0f);
}

json passes_json(const std::vector<PassTime>& times) {
    json passes = json::array();
    std::vector<PassTime> sums;  // a pass may have been recorded more than once
    add_times(sums, times);
    for (const PassTime& time : sums) passes.push_back({time.name, time.stage, time.gpu_ms});
    return passes;
}

json Pictures::draw_live(const json& request, std::string& bytes) {
    const bool changed = gpu_.pipelines.forget_changed_files();
    Warm& warm = find(request.at("words").get<Words>());
    Exercises::use("solution");  // after words were read, which name exercises too
    Exercises::use(request.value("use", "solution"));
    turn(warm, request);
    const glm::uvec2 size = size_of(request, warm.options);
    const bool still = request.value("still", false);
    const int frames = still ? std::min(warm.options.frames, most_frames) : 1;
    const float time_s = warm.options.time_s + request.value("time_s", 0.0f);
    const Look look{.output = request.value("look", "")};
    gpu_.pipelines.errors.clear();
    if (still) warm.chapter->forget_history();
    look.attach(*warm.frame, warm.looked_at, warm.chapter->camera, warm.chapter->scene.bounds);
    Picture drawn{.size = size, .time_s = time_s, .seed = warm.options.seed, .crop = {}};
    if (!still) drawn.gathered = 0;
    for (int i = 0; i < frames; ++i, drawn.time_s = time_s + static_cast<float>(i) / 60.0f)
        warm.live->draw(*warm.frame, drawn);
    json said{{"code", 0}, {"error", ""}};
    if (const std::string wrong = warm.live->load_error + warm.live->frame_error; !wrong.empty())
        said = {{"code", 1}, {"error", wrong}};
    else
        look.check(*warm.frame);
    if (warm.live->frame_error.empty()) {
        const Image8 picture = read_picture(gpu_, look.picture(*warm.frame, warm.looked_at));
        bytes = still ? encode_png(picture) : encode_jpeg(picture, moving_quality);
    }
    said["size"] = {size.x, size.y};
    said["format"] = still ? "png" : "jpeg";
    said["passes"] = passes_json(warm.frame->times);
    said["looks"] = Look::names(*warm.frame);
    said["status"] = warm.chapter->all_status();
    said["moves"] = warm.chapter->any_animated();
    said["changed"] = changed;
    said["device"] = gpu_.device.info.name;
    json& errors = said["errors"] = json::array();
    for (const auto& [pipeline, error] : gpu_.pipelines.errors) errors.push_back(error);
    return said;
}

json Pictures::answer(const json& request, std::string& bytes) {
    gpu_.pipelines.keep_last_good = request.is_object();
    if (request.is_object()) return draw_live(request, bytes);
    draw_file(request.get<Words>());
    return {{"code", 0}, {"error", ""}};
}

}  // namespace

int draw_pictures(const Options& options, const std::string& name, const MakeChapter& make, std::unique_ptr<Gpu>& gpu) {
    gpu = make_gpu(options);
    Pictures pictures(name, make, gpu);
    for (std::string line; std::getline(std::cin, line);) {
        std::string bytes;
        json said;
        try {
            said = pictures.answer(json::parse(line), bytes);
        } catch (const InputError& e) { said = {{"code", 2}, {"error", e.what()}}; } catch (const json::exception&) {
            said = {{"code", 2}, {"error", "a line is no request: " + line.substr(0, 200)}};
        } catch (const std::exception& e) { said = {{"code", 1}, {"error", e.what()}}; }
        if (said["code"] == 2) bytes.clear();
        said["bytes"] = bytes.size();
        std::printf("%s\n", said.dump(-1, ' ', false, json::error_handler_t::replace).c_str());
        std::fwrite(bytes.data(), 1, bytes.size(), stdout);
        std::fflush(stdout);
    }
    return 0;
}

}  // namespace lightwalk
