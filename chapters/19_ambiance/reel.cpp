#include "19_ambiance/reel.h"

#include "14_environment/sound_file.h"
#include "19_ambiance/exercises.h"
#include "19_ambiance/level_file.h"
#include "common/base/error.h"

namespace lightwalk {

bool is_film_file(const std::filesystem::path& file) { return file.extension() == ".film"; }

void Reel::prepare(Gpu&, Scene& loaded) {
    parts_.clear();
    chosen_.reset();
    film_ = is_film_file(loaded.file.file) ? read_timeline(loaded.file.file) : Timeline();
    has_sound_ = false;
    if (!film_.music) return music.take({});
    try {
        music.take({}, read_levels(levels_of(find_asset(film_.music.file))));
    } catch (const InputError& e) { throw InputError("{}: {}", film_.music.where, e.what()); }
}

// Decoding takes longer than most pictures, and a picture needs the levels alone.
void Reel::load_sound() {
    if (has_sound_ || !film_.music) return;
    LevelTable measured = music.measured_levels();
    music.take(read_sound(find_asset(film_.music.file)), std::move(measured));
    has_sound_ = true;
}

void Reel::choose(const std::optional<PathKind>& kind) {
    if (kind == chosen_) return;
    for (FilmScene& scene : film_.scenes) scene.camera.choose(kind.value_or(scene.path));
    chosen_ = kind;
}

// [make_ready]
void Reel::make_ready(Gpu& gpu, glm::uvec2 size, double time_s, double later_s, bool plays) {
    std::vector<OnScreen> times;
    for (const FilmScene& scene : film_.scenes) times.push_back({scene.from_s, scene.to_s});
    const std::vector<int> wanted = warm(times, time_s, plays ? double(ahead_s) : later_s, plays ? int(most) : 3);
    std::erase_if(parts_, [&](const auto& part) {
        return std::find(wanted.begin(), wanted.end(), int(part.first)) == wanted.end();
    });
    for (const int i : wanted) {
        const auto place = static_cast<size_t>(i);
        if (const auto there = parts_.find(place); there != parts_.end()) {
            if (there->second->is_loaded()) continue;
            parts_.erase(there);
        }
        const FilmScene& scene = film_.scenes.at(place);
        std::unique_ptr<FilmPart> part = make_part(scene, music);
        part->load(gpu);
        if (scene.from_s > time_s) {  // it is not seen yet
            Frame unseen(gpu);
            part->begin_frame(gpu, size);
            unseen.begin(size, static_cast<float>(scene.from_s));
            part->record(unseen, scene.from_s, {});
            unseen.end();
        }
        parts_[place] = std::move(part);
    }
    for (const auto& [place, part] : parts_) part->begin_frame(gpu, size);
}
// [/make_ready]

// [record]
void Reel::record(Frame& frame, double time_s) {
    const std::vector<Timeline::Shown> shown = film_.shown(time_s);
    for (size_t i = 0; i < shown.size(); ++i) {
        parts_.at(shown[i].scene)->record(frame, time_s, film_.faded(time_s));
        if (i + 1 == shown.size()) continue;
        frame.compute("keep", {.reads = {frame.hdr}, .writes = {before_}}, [&](Compute& pass) {
            pass.use(copy_).set("from", frame.hdr, nearest_clamp).set("into", before_);
            pass.dispatch_threads(frame.size);
        });
    }
    if (shown.size() == 2)
        frame.compute("cross-fade", {.reads = {before_, frame.hdr}, .writes = {frame.hdr}}, [&](Compute& pass) {
            pass.use(mix_).set("before", before_, nearest_clamp).set("picture", frame.hdr);
            pass.set("share", shown[1].share).dispatch_threads(frame.size);
        });
    if (shown.empty())  // black
        frame.compute("black", {.writes = {frame.hdr}},
                      [&](Compute& pass) { pass.use(black_).set("picture", frame.hdr).dispatch_threads(frame.size); });
}
// [/record]

}  // namespace lightwalk
