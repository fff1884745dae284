// A chapter: knobs, modules, passes and one frame. Members register themselves.
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

/// An extra of a chapter's command line that runs instead of a frame: --flag ARGUMENT.
struct Command {
    std::string flag, argument, help;
    /// Returns the exit code. Where it needs a device it makes it in `gpu`, which outlives the chapter.
    std::function<int(const std::string& argument, const Options& options, std::unique_ptr<Gpu>& gpu)> run;
};

/// Large (9 functions, 9 members): the root: scene, camera, commands.
class Chapter : public Module {
  public:
    std::string name;                    ///< NN_name
    std::string method_knob = "method";  ///< which knob holds the methods of the study and of --method auto
    std::vector<Command> commands;
    std::shared_ptr<Subject> subject;  ///< the subject of its study, if not a frame (common/study/subject.h)
    Scene scene;
    Camera camera;  ///< the scene's, moved by the window

    // [samples]
    Knob<int> samples{*this, "samples", 1, {1, 4096}, "pictures, each shifted within a pixel, whose mean is shown"};
    // [/samples]

    /// Below assets/: shown without --scene.
    virtual std::string default_scene() const = 0;
    virtual Model load_model(const std::filesystem::path& file) = 0;

    /// Called before a frame at this time: makes resources that were not loaded with the scene. Later times may
    /// follow if `plays` is true.
    virtual void make_ready(Gpu& /*gpu*/, glm::uvec2 /*size*/, float /*time_s*/) {}

    /// The time of the frame that is so many frames before the one at `time_s`, where a picture is gathered.
    virtual float gathered_at(float time_s, int frames_before) const {
        return time_s - static_cast<float>(frames_before) / 60.0f;
    }

    bool plays = false;  ///< its clock runs: in a window, or where a film is written

    int camera_of_file = 0;  ///< which of the cameras in a bare model's file is used, from 1 on; 0: none

    bool tries_knobs = false;  ///< the need rule draws: knobs have values that nobody has set

    /// Records one frame and leaves the picture in frame.output.
    virtual void frame(Frame& frame) = 0;

    /// The image that a study judges after a frame: linear light, the encoded picture, or one level of an image of
    /// either format.
    virtual ImageView judged(const Frame& frame) const { return frame.linear(); }

    /// The image that the need rule judges: the encoded, rounded and tone-mapped picture, as written to a file.
    virtual ImageView written(const Frame& frame) const { return frame.output; }

    /// Adds the chapter's own errors for a point of its study to `error`, by name. NaN counts as a non-finite error,
    /// an absent name as not measured. Called after the point's picture of `size` was rendered, with its knobs in
    /// effect. It may set knobs and render more frames in a Frame of its own; knobs are restored afterwards.
    virtual void measure(Gpu& /*gpu*/, glm::uvec2 /*size*/, nlohmann::json& /*error*/) {}

    /// Likely cause of a non-finite picture, and the remedy, for its error message.
    virtual std::string why_not_finite() const { return {}; }

    bool animated() const override { return scene.moves(); }
};

using MakeChapter = std::function<std::unique_ptr<Chapter>()>;

/// Called while a scene is loaded, if the need rule chooses the method.
struct Loading {
    std::function<void()> before;     ///< chapter.scene.file is read, and nothing loaded
    std::function<void(Gpu&)> after;  ///< all is loaded and prepared
};

/// Reads a scene file or wraps a model file, and loads it. Throws InputError.
void load_scene(Chapter& chapter, Gpu& gpu, const std::filesystem::path& file, const Loading& loading = {});

}  // namespace lightwalk
