#include "19_ambiance/reel.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstring>
#include <utility>

#include "14_environment/music.h"
#include "19_ambiance/exercises.h"
#include "common/base/error.h"
#include "common/base/exercise.h"
#include "common/base/files.h"
#include "common/gpu/warm_up.h"
#include "common/scene/scene_file.h"

namespace lightwalk {

namespace {

// The time of a step, as frames have it, may round to before it.
constexpr double just_after_s = 1e-4;

}  // namespace

bool is_film_file(const std::filesystem::path& file) { return file.extension() == ".film"; }

void Reel::prepare(Gpu&, Scene& loaded) {
    ahead_.reset();
    parts_.clear();
    ways_.clear();
    chosen_.reset();
    paths_made_.forget();
    film_ = is_film_file(loaded.file.file) ? read_timeline(loaded.file.file) : Timeline();
    if (is_open() && !cut.is("whole")) film_ = cut_of(film_, cut.text());
    has_sound_ = false;
    sound_ = {};
    if (!film_.music) return music.take({});
    try {
        music.take({}, read_levels(levels_of(find_asset(film_.music.file))));
    } catch (const InputError& e) { throw InputError("{}: {}", film_.music.where, e.what()); }
}

// Decoding takes longer than most pictures, and a picture needs the levels alone.
void Reel::load_sound() {
    if (has_sound_ || !film_.music) return;
    const auto read = [file = find_asset(film_.music.file), from_s = film_.music.from_s] {
        Sound sound = read_sound(file);
        const auto cut_off = static_cast<size_t>(from_s * sound.rate_hz);
        sound.samples.erase(sound.samples.begin(), sound.samples.begin() + std::min(cut_off, sound.samples.size()));
        return sound;
    };
    if (!sound_.valid()) sound_ = std::async(read);
    if (sound_.wait_for(std::chrono::seconds(0)) == std::future_status::timeout) return;
    LevelTable measured = music.measured_levels();
    music.take(sound_.get(), std::move(measured));
    has_sound_ = true;
}

void Reel::choose(const std::optional<PathKind>& kind) {
    if (paths_made_.is_current(kind, Exercises::epoch())) return;
    for (FilmScene& scene : film_.scenes) scene.camera.choose(kind.value_or(scene.path));
    chosen_ = kind;
}

// [prepare_frame]
void Reel::prepare_frame(Gpu& gpu, glm::uvec2 size, double time_s, double later_s, bool plays) {
    std::vector<OnScreen> times;
    for (const FilmScene& scene : film_.scenes) times.push_back({scene.from_s, scene.to_s});
    const size_t room = plays ? size_t(most) : 3;
    const std::vector<int> wanted = warm(times, time_s, plays ? double(ahead_s) : later_s, int(room));

    // 1. Parts from the worker; parts of other toggles go.
    if (plays && !ahead_) start_ahead(gpu, size);
    if (ahead_) take_made();
    const bool toggled = !toggles_.is_current(Exercises::epoch());
    std::erase_if(parts_, [&](const auto& part) {
        const FilmScene& scene = film_.scenes.at(part.first);
        const bool on_screen = scene.from_s <= time_s + later_s && time_s < scene.to_s;  // tracks set its knobs
        return (toggled || on_screen) && !part.second->is_loaded();
    });
    drop_parts(wanted, room);

    // 2. Scenes on the screen: this frame waits for them. The worker makes the rest.
    std::vector<size_t> later;
    for (const int i : wanted) {
        const auto place = static_cast<size_t>(i);
        if (parts_.contains(place)) continue;
        if (plays && film_.scenes.at(place).from_s > time_s + later_s)
            later.push_back(place);
        else
            need(gpu, size, place, plays);
    }
    if (ahead_) ahead_->ask(later);
    unseen_size_ = size;
    begin_frame(gpu, size);
    for (const auto& [place, part] : parts_) part->begin_frame(gpu, size);
}

// Draws it once with all of a film's effects on a scene, at all times at which it may need something new.
std::unique_ptr<FilmPart> Reel::made(Gpu& gpu, glm::uvec2 size, size_t place, bool plays) {
    auto part = std::make_unique<FilmPart>(film_.scenes.at(place), film_.music ? &music : nullptr);
    part->load(gpu);
    part->draw_by(ways_[place]);
    for (const double at_s : plays ? film_.turns(place) : std::vector<double>{}) {
        Frame unseen(gpu);
        part->begin_frame(gpu, size);
        unseen.begin(size, static_cast<float>(at_s));
        part->record(unseen, at_s + just_after_s, {.black = 0.5f, .white = 0.5f});
        unseen.end();
    }
    return part;
}

void Reel::start_ahead(Gpu& gpu, glm::uvec2 size) {
    unseen_size_ = size;
    ahead_ = std::make_unique<Ahead>([this, &gpu, is_first = true](size_t place) mutable {
        if (std::exchange(is_first, false) && before_scenes) before_scenes(gpu);
        const WarmUp later;
        return made(gpu, unseen_size_, place, true);
    });
    titles_.prepare(gpu, film_);
    Frame unseen(gpu);  // fades between two scenes, and black
    begin_frame(gpu, size);
    unseen.begin(size, 0);
    show_black(unseen);
    keep(unseen);
    mix(unseen, 0.5f);
    unseen.end();
}

void Reel::take_made() {
    for (auto& [place, part] : ahead_->take()) {
        if (!part->is_loaded()) continue;  // a toggle has changed meanwhile
        part->draw_by(ways_[place]);
        parts_[place] = std::move(part);
    }
}

void Reel::need(Gpu& gpu, glm::uvec2 size, size_t place, bool plays) {
    while (ahead_ && ahead_->is_making(place)) ahead_->wait();
    if (ahead_) {
        take_made();
        ahead_->ask({});  // not this one as well
    }
    if (!parts_.contains(place)) parts_[place] = made(gpu, size, place, plays);
}

bool Reel::is_ready(double time_s) const {
    const std::vector<Timeline::Shown> shown = film_.shown(time_s);
    return !ahead_ || std::ranges::all_of(shown, [&](const Timeline::Shown& one) {
        return parts_.contains(one.scene) || ahead_->has(one.scene);
    });
}

void Reel::wait_until_ready() {
    while (ahead_ && ahead_->is_busy()) ahead_->wait();
    if (ahead_) take_made();
}

// Freeing a scene's memory is work as well. Hard cuts took 13 to 18 ms on a GPU while each of them dropped the scene before;
// that this was the cause is not measured. Now a scene is dropped only if there is no room for another one.
void Reel::drop_parts(const std::vector<int>& wanted, size_t room) {
    const auto is_wanted = [&](size_t place) {
        return std::find(wanted.begin(), wanted.end(), int(place)) != wanted.end();
    };
    const auto missing = static_cast<size_t>(std::count_if(
        wanted.begin(), wanted.end(), [&](int place) { return !parts_.contains(static_cast<size_t>(place)); }));
    for (auto part = parts_.begin(); part != parts_.end() && parts_.size() + missing > room;)
        part = is_wanted(part->first) ? std::next(part) : parts_.erase(part);
}
// [/prepare_frame]

void Reel::draw_by(size_t scene, KnobSettings way) {
    if (const auto part = parts_.find(scene); part != parts_.end()) part->second->draw_by(way);
    ways_[scene] = std::move(way);
}

void Reel::apply_knobs(const Chapter& chapter, double time_s) const {
    for (const Track& track : film_.knobs) try {
            KnobBase*& knob = chapter_knobs_[track.name];
            if (!knob) knob = &find_knob(chapter.all_knobs(), track.name);
            if (!knob->pinned) knob->set(track.at(time_s));
        } catch (const InputError& e) { throw InputError("{}: {}", track.where, e.what()); }
}

std::optional<size_t> Reel::scene_at(double time_s) const {
    const std::vector<Timeline::Shown> shown = film_.shown(time_s);
    return shown.empty() ? std::nullopt : std::optional(shown.back().scene);
}

double Reel::steady_from_s(double time_s) const {
    double latest_s = 0;
    for (const FilmScene& scene : film_.scenes)
        for (const double at_s : {scene.from_s, scene.to_s})
            if (at_s <= time_s) latest_s = std::max(latest_s, at_s);
    return latest_s;
}

std::optional<Camera> Reel::camera_at(double time_s) const {
    const std::optional<size_t> scene = scene_at(time_s);
    const auto part = scene ? parts_.find(*scene) : parts_.end();
    return part == parts_.end() ? std::nullopt : std::optional(part->second->camera_at(time_s));
}

bool Reel::take_cameras(const Timeline& edited) {
    const auto same = [](const FilmScene& a, const FilmScene& b) {
        return a.name == b.name && a.from_s == b.from_s && a.to_s == b.to_s;
    };
    if (!std::equal(film_.scenes.begin(), film_.scenes.end(), edited.scenes.begin(), edited.scenes.end(), same))
        return false;
    for (size_t i = 0; i < film_.scenes.size(); ++i) {
        film_.scenes[i].camera = edited.scenes[i].camera;
        film_.scenes[i].path = edited.scenes[i].path;
        if (chosen_) film_.scenes[i].camera.choose(*chosen_);
    }
    return true;
}

void Reel::record(Frame& frame, double time_s, const Camera& flown) {
    const std::vector<Timeline::Shown> shown = film_.shown(time_s);
    alone_ = shown.size() == 1 ? parts_.at(shown[0].scene).get() : nullptr;
    for (size_t i = 0; i < shown.size(); ++i) {
        const bool by_hand = fly && i + 1 == shown.size();
        parts_.at(shown[i].scene)->record(frame, time_s, film_.faded(time_s), by_hand ? &flown : nullptr);
        if (i + 1 < shown.size()) keep(frame);
    }
    if (shown.size() == 2) mix(frame, shown[1].share);
    if (shown.empty()) show_black(frame);
}

void Reel::show_black(Frame& frame) {
    frame.compute("black", {.writes = {frame.hdr}},
                  [&](Compute& pass) { pass.use(black_).set("picture", frame.hdr).dispatch_threads(frame.size); });
}

void Reel::keep(Frame& frame) {
    frame.compute("keep", {.reads = {frame.hdr}, .writes = {before_}}, [&](Compute& pass) {
        pass.use(copy_).set("from", frame.hdr, nearest_clamp).set("into", before_);
        pass.dispatch_threads(frame.size);
    });
}

void Reel::mix(Frame& frame, float share) {
    frame.compute("cross-fade", {.reads = {before_, frame.hdr}, .writes = {frame.hdr}}, [&](Compute& pass) {
        pass.use(mix_).set("before", before_, nearest_clamp).set("picture", frame.hdr);
        pass.set("share", share).dispatch_threads(frame.size);
    });
}

Ahead::Ahead(Make make) : make_(std::move(make)), thread_([this] { run(); }) {}

Ahead::~Ahead() {
    stop_ = true;
    wake();
    const SharedLock::Unlocked others;
    thread_.join();
}

void Ahead::ask(const std::vector<size_t>& places) {
    asked_.assign(places.begin(), places.end());
    std::erase_if(asked_, [&](size_t place) { return is_making(place) || made_.contains(place); });
    if (!asked_.empty()) wake();
}

void Ahead::wake() {
    if (std::exchange(sleeps_, false)) wake_.release();
}

std::map<size_t, std::unique_ptr<FilmPart>> Ahead::take() {
    if (failed_) std::rethrow_exception(std::exchange(failed_, nullptr));
    return std::exchange(made_, {});
}

void Ahead::wait() {
    const auto count = made_.size();
    while (is_busy() && made_.size() == count && !failed_) {
        const SharedLock::Unlocked others;
        done_.acquire();
    }
}

void Ahead::run() {
    SharedLock::stop_when(&stop_);
    SharedLock::lock();
    while (!stop_) {
        if (asked_.empty()) {
            sleeps_ = true;
            const SharedLock::Unlocked others;
            wake_.acquire();
            continue;
        }
        making_ = asked_.front();
        asked_.pop_front();
        try {
            made_[*making_] = make_(*making_);
        } catch (const SharedLock::Stopped&) {
            // Nobody waits for it.
        } catch (...) {
            failed_ = std::current_exception();
            asked_.clear();
        }
        making_.reset();
        done_.release();
    }
    SharedLock::unlock();
}

namespace {

constexpr size_t most_bytes = size_t{64} << 20;
using Codes = glm::u16vec4;

}  // namespace

std::filesystem::path levels_of(const std::filesystem::path& music) {
    return std::filesystem::path(music).replace_extension(".levels");
}

LevelTable read_levels(const std::filesystem::path& file) {
    if (!file_exists(file)) throw InputError("no file {}; --levels writes it", file.string());
    const std::string bytes = read_file(file, most_bytes);
    Levels most;
    if (bytes.size() < sizeof most || (bytes.size() - sizeof most) % sizeof(Codes) != 0)
        throw InputError("{}: cut off; --levels writes it", file.string());
    std::memcpy(&most, bytes.data(), sizeof most);
    if (!(glm::length(most) < 1e3f)) throw InputError("{}: no table of levels; --levels writes one", file.string());
    LevelTable table;
    for (size_t at = sizeof most; at < bytes.size(); at += sizeof(Codes)) {
        Codes codes;
        std::memcpy(&codes, bytes.data() + at, sizeof codes);
        table.entries.push_back(most * glm::vec4(codes) / 65535.0f);
    }
    return table;
}

void write_levels(const std::filesystem::path& music) {
    const std::filesystem::path file = find_asset(music);
    const LevelTable table = measure_levels(read_sound(file));
    const Levels most = table.most();
    std::string bytes(reinterpret_cast<const char*>(&most), sizeof most);
    for (const Levels& levels : table.entries) {
        const Codes codes(glm::round(65535.0f * levels / glm::max(most, Levels(1e-9f))));
        bytes.append(reinterpret_cast<const char*>(&codes), sizeof codes);
    }
    write_file(levels_of(file), bytes);
}

}  // namespace lightwalk
