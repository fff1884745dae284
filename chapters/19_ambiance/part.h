// A scene of the film: a scene file, an earlier chapter's world that shows it, and a camera path.
#pragma once
#include <functional>
#include <map>
#include <memory>
#include <set>

#include "08_bloom/bloom.h"
#include "09_post_effects/post.h"
#include "14_environment/music.h"
#include "19_ambiance/timeline.h"
#include "common/app/world.h"

namespace lightwalk {

/// Knobs of a part by name, each with the text that KnobBase::set takes.
using KnobSettings = std::vector<std::pair<std::string, std::string>>;

/// Lives while the film needs it (19.warm): made before its scene is on the screen, dropped after it. A part has no
/// state of its own: its picture follows from the time and the size alone. It has no owner, like a chapter: its knobs
/// are the film's to set, and come and go with it.
class FilmPart : public Module {
  public:
    /// `scene` must stay; `heard`: the film's music; null: the scene's own.
    explicit FilmPart(const FilmScene& scene, Music* heard = nullptr);

    /// Reads its scene file, and prepares its drawings. Throws InputError.
    void load(Gpu& gpu);

    /// Draws the scene at the film's time: light, bloom, the film's fade, tones. Leaves display values in frame.hdr,
    /// 0 to 1 and still linear. `flown`: a camera instead of the scene's; may be null.
    void record(Frame& frame, double time_s, Timeline::Faded faded, const Camera* flown = nullptr);

    /// On its path, at the film's time.
    Camera camera_at(double time_s) const {
        return film_scene_.camera.at(film_scene_.clock_at(time_s), scene_.file.camera);
    }
    /// Sets knobs over the scene file's and its tracks' values, instead of earlier ones; {}: none.
    void draw_by(const KnobSettings& way);

    /// View, scene and drawings of record(), for methods that follow surfaces.
    const View& view() const { return view_; }
    const Scene& drawn() const { return scene_; }
    Drawings drawings() const { return world_->drawings(); }

    const FilmScene& scene() const { return film_scene_; }
    bool is_loaded() const;  ///< nothing that load() depends on has changed since

  private:
    Scene scene_;
    View view_;
    std::unique_ptr<World> world_;
    Bloom bloom_{*this, "bloom"};
    Post post_{*this, "post"};
    void apply_knobs(double clock_s);
    double fullest_clock_s();                 ///< of the entries of tracks that step; applies knobs
    KnobBase& knob(const std::string& name);  ///< throws InputError
    const FilmScene& film_scene_;
    std::set<std::string> loaded_with_;  ///< modules in use, keys and exercises, as load_state() has them
    std::map<std::string, KnobBase*> knobs_;
    KnobSettings way_, before_way_;
    Pipeline fade_ = compute({.shader = "19_ambiance/fade.comp"});
};

struct Music;

/// Makes a world with the owner's members. `heard`: the film's music; null: the scene's own.
using MakeWorld = std::function<std::unique_ptr<World>(Module& owner, Music* heard)>;
const std::map<std::string, MakeWorld>& film_worlds();

}  // namespace lightwalk
