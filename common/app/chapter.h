// A chapter: its knobs, its modules, its passes and one frame. What it declares as members registers itself.
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

class Chapter : public Module {
  public:
    std::string name;                    ///< NN_name
    std::string method_knob = "method";  ///< which knob holds the methods of the study and of --method auto
    std::vector<Command> commands;
    std::shared_ptr<Subject> subject;  ///< what its study measures where that is no frame (common/study/subject.h)
    Scene scene;
    Camera camera;  ///< the scene's, moved by the window

    // [samples]
    Knob<int> samples{*this, "samples", 1, {1, 4096}, "pictures, each shifted within a pixel, whose mean is shown"};
    // [/samples]

    /// Below assets/: shown without --scene.
    virtual std::string default_scene() const = 0;
    virtual Model load_model(const std::filesystem::path& file) = 0;

    /// Before a frame at this time is begun: what it needs and was not loaded with the scene is made now. Later times may
    /// follow where `plays` says so.
    virtual void make_ready(Gpu& /*gpu*/, glm::uvec2 /*size*/, float /*time_s*/) {}
    bool plays = false;  ///< its clock runs: in a window, or where a film is written

    int camera_of_file = 0;  ///< which of the cameras in a bare model's file is used, from 1 on; 0: none

    bool tries_knobs = false;  ///< the need rule draws: knobs have values that nobody has set

    /// Records one frame; what it leaves in frame.output is the picture.
    virtual void frame(Frame& frame) = 0;

    /// What a study looks at of the frame drawn last: linear light, the encoded picture, or a level of an image of
    /// either format.
    virtual ImageView judged(const Frame& frame) const { return frame.linear(); }

    /// What the need rule looks at of it: the picture as the program would write it, encoded, rounded, with its tones.
    virtual ImageView written(const Frame& frame) const { return frame.output; }

    /// Errors of the chapter's own for a point of its study: adds numbers by name to `error`, beside those of the
    /// picture; NaN counts as an error that is not finite, and a name left out as not measured. Called when the point's
    /// picture of `size` was rendered, with the point's knobs in effect; it may set knobs and render further frames, in
    /// a Frame of its own, and finds its knobs put back afterwards.
    virtual void measure(Gpu& /*gpu*/, glm::uvec2 /*size*/, nlohmann::json& /*error*/) {}

    /// For the error where the picture is not finite: what may have caused that, and what to do.
    virtual std::string why_not_finite() const { return {}; }

    bool animated() const override { return scene.moves(); }
};

using MakeChapter = std::function<std::unique_ptr<Chapter>()>;

/// What is to be done while a scene is loaded: where the need rule chooses.
struct Loading {
    std::function<void()> before;     ///< chapter.scene.file is read, and nothing loaded
    std::function<void(Gpu&)> after;  ///< all is loaded and prepared
};

/// Reads a scene file or wraps a model file, and loads it. Throws InputError.
void load_scene(Chapter& chapter, Gpu& gpu, const std::filesystem::path& file, const Loading& loading = {});

}  // namespace lightwalk
