// The running film: its timeline, and the scenes ready to be drawn.
#pragma once
#include <deque>
#include <exception>
#include <filesystem>
#include <functional>
#include <future>
#include <map>
#include <semaphore>
#include <thread>
#include <vector>

#include "14_environment/music.h"
#include "19_ambiance/part.h"
#include "19_ambiance/titles.h"
#include "common/app/chapter.h"
#include "common/app/target.h"
#include "common/base/epoch.h"
#include "common/base/shared_lock.h"

namespace lightwalk {

/// audio/a.levels for audio/a.ogg.
std::filesystem::path levels_of(const std::filesystem::path& music);

/// Each level as a share of its largest, in 16 bits. Throws InputError where the file is missing or cut off.
LevelTable read_levels(const std::filesystem::path& file);

/// Measures a piece of music and writes its table beside it. Throws InputError.
void write_levels(const std::filesystem::path& music);

/// Makes parts in the order asked for, one after the other, in turns with the thread that draws (common/base/shared_lock.h).
/// That thread alone calls these functions.
class Ahead {
  public:
    using Make = std::function<std::unique_ptr<FilmPart>(size_t place)>;
    explicit Ahead(Make make);
    ~Ahead();  ///< stops at the part's next file, shader or texture
    Ahead(const Ahead&) = delete;

    /// The parts to make from now on. Replaces earlier lists, but for the part in the making.
    void ask(const std::vector<size_t>& places);

    /// Parts that are ready. Rethrows what a maker threw.
    std::map<size_t, std::unique_ptr<FilmPart>> take();

    bool has(size_t place) const { return made_.contains(place); }
    bool is_making(size_t place) const { return making_ == place; }
    bool is_busy() const { return making_ || !asked_.empty(); }
    void wait();  ///< for the part in the making, or the next one

  private:
    void run();
    void wake();
    const Make make_;
    const SharedLock::InUse shared_;
    std::deque<size_t> asked_;
    std::optional<size_t> making_;
    std::map<size_t, std::unique_ptr<FilmPart>> made_;
    std::exception_ptr failed_;
    std::atomic<bool> stop_ = false;
    bool sleeps_ = false;
    std::counting_semaphore<> wake_{0}, done_{0};
    std::thread thread_;
};

/// Whether a file is to be read as a film.
bool is_film_file(const std::filesystem::path& file);

/// Draws a film at a time. Every picture is a function of the time alone: parts keep nothing from frame to frame.
struct Reel : Module {
    Reel(Module& owner, std::string name) : Module(owner, std::move(name), "reel") {}

    Knob<float> ahead_s{*this,
                        "ahead_s",
                        3600.0f,
                        {0.0f, 3600.0f},
                        "Time before a scene begins at which it is made ready, while the film plays",
                        "s"};
    Knob<int> most{*this, "most", 32, {1, 64}, "Number of scenes that are kept ready at most, while the film plays"};
    Choice cut{*this, "cut", {"whole", "short"}, "whole", "Version of the film: the whole, or 90 seconds of it"};
    Knob<bool> fly{*this, "fly", false, "Camera of the scene flown by hand, instead of its path"};
    Music music{*this, "music"};

    /// True where the scene that was loaded is a film. Else nothing is drawn.
    bool is_open() const { return !film_.file.empty(); }
    const Timeline& film() const { return film_; }

    /// Loads the scenes on the screen from `time_s` to `later_s` after it. `plays`: later times will follow. Then a worker
    /// loads the others that 19.warm requests and draws each once, unseen, so that its first visible picture finds its
    /// pipelines and targets made.
    void prepare_frame(Gpu& gpu, glm::uvec2 size, double time_s, double later_s, bool plays);

    /// Whether the scenes on the screen at a time are loaded, or prepare_frame() makes them because no worker does.
    bool is_ready(double time_s) const;

    /// Waits for all scenes that the worker was asked for.
    void wait_until_ready();

    /// Decodes the film's music for playing, in a thread of its own; its levels are available without. The first call
    /// begins it, a later one takes it.
    void load_sound();

    /// Overrides the motion of all cameras; `pieces`: CameraPath's. None: the film's own.
    void choose(const std::optional<PathKind>& kind);

    /// Draws a scene with these knobs over the film's, from now on. {}: the film's.
    void draw_by(size_t scene, KnobSettings way);

    /// Sets the knobs of a chapter from the film's tracks, except for those of the command line. Throws InputError.
    void apply_knobs(const Chapter& chapter, double time_s) const;

    /// The picture at a time, 0 to 1 in linear light: one scene, or two that are mixed; black where there is none.
    /// `flown`: the camera of the scene that is shown, or shown next, while `fly` is on.
    void record(Frame& frame, double time_s, const Camera& flown = {});
    void record_titles(Frame& frame, const Image& picture, double time_s) {
        titles_.record(frame, picture, film_, time_s);
    }

    /// The one scene that record() drew in this frame; null where there was none, or two were mixed.
    const FilmPart* alone() const { return alone_; }

    /// Since when the same scenes have been shown: the latest cut, or end of a cross-fade.
    double steady_from_s(double time_s) const;

    /// The scene on the screen, of two the later one; none in a gap.
    std::optional<size_t> scene_at(double time_s) const;
    /// Its camera on its path; none where it is not loaded.
    std::optional<Camera> camera_at(double time_s) const;
    /// The cameras of another version of the film's file. False where its scenes are others.
    bool take_cameras(const Timeline& edited);

    const std::map<size_t, std::unique_ptr<FilmPart>>& parts() const { return parts_; }

    /// Called by the worker before its first scene.
    std::function<void(Gpu&)> before_scenes;

    bool load_proxy(const std::filesystem::path& file, Model&) const override { return is_film_file(file); }
    /// Reads the film. Throws InputError.
    void prepare(Gpu&, Scene&) override;
    std::string load_key() const override { return cut.text(); }
    bool animated() const override { return is_open(); }

  private:
    void drop_parts(const std::vector<int>& wanted, size_t room);
    std::unique_ptr<FilmPart> made(Gpu& gpu, glm::uvec2 size, size_t place, bool plays);
    void start_ahead(Gpu& gpu, glm::uvec2 size);
    void take_made();
    void need(Gpu& gpu, glm::uvec2 size, size_t place, bool plays);
    void show_black(Frame& frame);
    void keep(Frame& frame);
    void mix(Frame& frame, float share);

    Timeline film_;
    std::optional<PathKind> chosen_;
    Fingerprint paths_made_;
    std::map<size_t, std::unique_ptr<FilmPart>> parts_;  ///< by their place in the film
    std::map<size_t, KnobSettings> ways_;                ///< likewise
    const FilmPart* alone_ = nullptr;
    mutable std::map<std::string, KnobBase*> chapter_knobs_;  ///< of the film's tracks
    Fingerprint toggles_;
    std::future<Sound> sound_;
    bool has_sound_ = false;
    Titles titles_;
    glm::uvec2 unseen_size_{0};
    Target before_{*this, {.name = "before", .kept = true}};
    Pipeline copy_ = compute({.shader = "19_ambiance/copy.comp"}),
             black_ = compute({.shader = "19_ambiance/black.comp"});
    Pipeline mix_ = compute({.shader = "19_ambiance/mix.comp"});
    std::unique_ptr<Ahead> ahead_;  ///< goes first: it uses the others
};

}  // namespace lightwalk
