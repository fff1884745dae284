// Base class of a chapter.
#pragma once
#include <functional>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "common/app/module.h"
#include "common/gpu/frame.h"
#include "common/scene/scene.h"

namespace lightwalk {

struct Options;
struct Subject;

struct Command {
    std::string flag, argument, help;
    /// Returns the exit code. Creates a device in `gpu` if needed; `gpu` outlives the chapter.
    std::function<int(const std::string& argument, const Options& options, std::unique_ptr<Gpu>& gpu)> run;
};

class Chapter : public Module {
  public:
    Chapter();
    ~Chapter() override;

    std::string name;
    std::string method_knob = "method";  ///< knob that a study and --method auto vary
    std::vector<Command> commands;
    std::shared_ptr<Subject> subject;  ///< measured by studies instead of frames; usually null (common/study/subject.h)
    Scene scene;
    Camera camera;

    Knob<int> samples{*this, "samples", 1, {1, 4096}, "pictures, each shifted within a pixel, whose mean is shown"};

    /// Scene file below assets/ used without --scene.
    virtual std::string default_scene() const = 0;
    virtual Model load_model(const std::filesystem::path& file) = 0;

    /// Called before each frame: creates resources not loaded with the scene. If `plays`, later times may follow.
    virtual void prepare_frame(Gpu& /*gpu*/, glm::uvec2 /*size*/, float /*time_s*/) {}

    /// Time, in seconds, of an earlier frame that accumulates into the picture at `time_s`.
    virtual float gathered_at(float time_s, int frames_before) const {
        return time_s - static_cast<float>(frames_before) / 60.0f;
    }

    bool scene_is_given = false;  ///< the person named the scene that is shown

    bool plays = false;  ///< animation clock running: in a window or while a film is written

    int camera_of_file = 0;  ///< 1-based camera of a bare model file; 0: none

    bool tries_knobs = false;  ///< need rule is rendering: knobs have trial values

    /// Records one frame; the final picture goes to frame.output.
    virtual void frame(Frame& frame) = 0;

    /// Image evaluated by a study: linear light, or the encoded picture, or one mip of an image of either format.
    virtual ImageView judged(const Frame& frame) const { return frame.linear(); }

    /// Image evaluated by the need rule: tone-mapped, encoded and quantised, as written to a file.
    virtual ImageView written(const Frame& frame) const { return frame.output; }

    /// Adds chapter-specific errors of a study point to `error`, by name. NaN: non-finite; missing: not measured.
    /// Called after the point was rendered at `size` with its knobs set. May set knobs, which are restored, and render
    /// in its own Frame.
    virtual void measure(Gpu& /*gpu*/, glm::uvec2 /*size*/, nlohmann::json& /*error*/) {}

    /// Likely cause and remedy, appended to the error message for a non-finite picture.
    virtual std::string why_not_finite() const { return {}; }

    bool animated() const override { return scene.moves(); }

    /// Height in metres below which the camera of a window does not go at a position; none: anywhere.
    virtual std::optional<float> lowest_eye_m(const glm::vec3& /*position*/) { return {}; }
};

using MakeChapter = std::function<std::unique_ptr<Chapter>()>;

/// Callbacks of load_scene(), for the need rule.
struct Loading {
    std::function<void()> before;     ///< scene file read, nothing loaded
    std::function<void(Gpu&)> after;  ///< everything loaded and prepared
};

/// Loads a scene file, or a model file with a default camera, light and ground. Throws InputError.
void load_scene(Chapter& chapter, Gpu& gpu, const std::filesystem::path& file, const Loading& loading = {});

}  // namespace lightwalk
