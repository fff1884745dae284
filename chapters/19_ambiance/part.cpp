#include "19_ambiance/part.h"

#include <algorithm>
#include <sstream>
#include <utility>

#include "01_obj/camera_view.h"
#include "01_obj/obj.h"
#include "common/app/foreign_scene.h"
#include "common/base/error.h"

namespace lightwalk {
namespace {

// The frame's clock, macros and uniform block are the part's while it draws.
class OwnFrame {
  public:
    OwnFrame(Frame& frame, double time_s, const FilmPart& part)
        : frame_(frame),
          time_before_(std::exchange(frame.time_s, static_cast<float>(time_s))),
          root_before_(std::exchange(frame.root, &part)) {}
    ~OwnFrame() {
        frame_.time_s = time_before_;
        frame_.root = root_before_;
    }
    OwnFrame(const OwnFrame&) = delete;

  private:
    Frame& frame_;
    const float time_before_;
    const PassInputs* const root_before_;
};

std::set<std::string> words_of(const std::string& load_state) {
    std::set<std::string> words;
    std::istringstream all(load_state);
    for (std::string word; std::getline(all, word, ';');) words.insert(word);
    return words;
}

}  // namespace

FilmPart::FilmPart(const FilmScene& scene, Music* heard)
    : world_(film_worlds().at(scene.kind)(*this, heard)), film_scene_(scene) {
    set_look(*world_, *this);
}

// By its path below the part, or by its name alone: the world's before that of bloom and tones.
KnobBase& FilmPart::knob(const std::string& name) {
    if (const auto known = knobs_.find(name); known != knobs_.end()) return *known->second;
    const KnobList all = all_knobs();
    for (KnobBase* one : all)
        if (one->path() == name) return *(knobs_[name] = one);
    try {
        return *(knobs_[name] = &find_knob(world_->all_knobs(), name));
    } catch (const InputError&) {  // it is the bloom's or the tones', or unclear
    }
    return *(knobs_[name] = &find_knob(all, name));
}

void FilmPart::load(Gpu& gpu) {
    std::filesystem::path file;
    try {
        file = find_asset(film_scene_.file);
    } catch (const InputError& e) { throw InputError("{}: {}", film_scene_.where, e.what()); }
    SceneFile read = read_scene(file);
    ForeignScene foreign(file, read, "19_ambiance", "a film's scene");
    foreign.set_knobs(read, [&](const std::string& name) -> KnobBase& { return knob(name); });
    apply_knobs(film_scene_.clock_s);
    scene_.load(gpu, std::move(read), [&](const std::filesystem::path& model) {
        return foreign.model(*this, model, [&] { return load_model(model, Loader::parallel); });
    });
    foreign.name_left_out();
    apply_knobs(fullest_clock_s());
    prepare_all(gpu, scene_);
    loaded_with_ = words_of(load_state());
}

// A module that a track switches on in mid-scene is prepared with the others: a load takes longer than a frame.
double FilmPart::fullest_clock_s() {
    double fullest_s = film_scene_.clock_s;
    size_t most = words_of(load_state()).size();
    for (const Track& track : film_scene_.knobs)
        for (const double time_s : track.steps ? track.times_s : std::vector<double>()) {
            apply_knobs(time_s);
            if (const size_t count = words_of(load_state()).size(); count > most) {
                most = count;
                fullest_s = time_s;
            }
        }
    return fullest_s;
}

bool FilmPart::is_loaded() const { return std::ranges::includes(loaded_with_, words_of(load_state())); }

void FilmPart::apply_knobs(double clock_s) {
    for (const Track& track : film_scene_.knobs) {
        try {
            knob(track.name).set(track.at(clock_s));
        } catch (const InputError& e) { throw InputError("{}: {}", track.where, e.what()); }
    }
    for (const auto& [name, value] : way_) knob(name).set(value);
}

void FilmPart::draw_by(const KnobSettings& way) {
    if (way == way_) return;
    for (const auto& [name, value] : before_way_) knob(name).set(value);
    before_way_.clear();
    for (const auto& [name, value] : way) before_way_.emplace_back(name, knob(name).text());
    way_ = way;
}

// [record]
void FilmPart::record(Frame& frame, double time_s, Timeline::Faded faded, const Camera* flown) {
    const double clock_s = film_scene_.clock_at(time_s);
    const OwnFrame own(frame, clock_s, *this);
    apply_knobs(clock_s);

    // 1. Its light, from where the camera is by now; the glare of what is bright.
    view_ = look_at(*world_, frame, scene_, flown ? *flown : camera_at(time_s));
    Canvas canvas(frame.hdr, frame.depth, world_->background());
    world_->draw_light(frame, view_, canvas);
    canvas.depth(frame);  // cleared where nothing has one
    bloom_.record(frame, frame.hdr);

    // 2. The film's fade, in linear light and before the tone curve: the brightest areas disappear last.
    if (faded.black > 0 || faded.white > 0)
        frame.compute("fade", {.reads = {frame.hdr}, .writes = {frame.hdr}}, [&](Compute& pass) {
            pass.use(fade_).set("picture", frame.hdr).set("faded", glm::vec2(faded.black, faded.white));
            pass.dispatch_threads(frame.size);
        });

    // 3. Its display values.
    post_.record(frame, frame.hdr);
}
// [/record]

}  // namespace lightwalk
