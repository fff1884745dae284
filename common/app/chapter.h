// A chapter: its knobs, its passes and one frame. What it declares as members registers itself.
#pragma once
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "common/app/knob.h"
#include "common/gpu/frame.h"
#include "common/scene/scene.h"

namespace lightwalk {

/// An extra of a chapter's command line that runs instead of a frame: --flag ARGUMENT.
struct Command {
    std::string flag, argument, help;
    std::function<int(const std::string& argument, bool json)> run;  ///< returns the exit code
};

/// A named picture: tests/NN_name/shots.json has a list of them.
struct Shot {
    std::string name, caption, scene;
    glm::uvec2 size{960, 540};
    float time_s = 0;
    int frames = 1;
    std::vector<std::pair<std::string, std::string>> set;
};

class Chapter {
  public:
    Chapter() { knobs_under_construction() = &knobs; }
    virtual ~Chapter();
    Chapter(const Chapter&) = delete;

    std::string name;  ///< NN_name
    KnobList knobs;
    std::string method_knob = "method";  ///< which knob holds the methods of the study and of --method auto
    Scene scene;
    Camera camera;  ///< the scene's, moved by the window

    /// Below assets/: shown without --scene.
    virtual std::string default_scene() const = 0;
    virtual Model load_model(const std::filesystem::path& file) = 0;

    /// Once after the scene was loaded and again after each reload.
    virtual void prepare(Gpu&) {}

    /// Records one frame; what it leaves in frame.output is the picture.
    virtual void frame(Frame& frame) = 0;
    virtual std::vector<Command> commands() { return {}; }

    /// The need rule: sets the cheapest method and knobs whose error in this scene and view is at most `budget`, from
    /// what can be measured of the scene. Returns what was measured, the rule and the choice, a line each. The first is
    /// called when scene.file is read and nothing loaded, the second when all is.
    virtual std::vector<std::string> choose_before_loading(double /*budget*/) { return {}; }
    virtual std::vector<std::string> choose(double /*budget*/, glm::uvec2 /*size*/) { return {}; }

    /// A study whose subject is not a frame: measures study.json's `scenes` on the CPU and puts into `result` the
    /// points and what else docs/study_format.md asks of a "loader". False: the subject is the frame.
    virtual bool cpu_study(const nlohmann::json& /*study*/, nlohmann::json& /*result*/) { return false; }

    /// Errors of the chapter's own for a point of its study: adds numbers by name to `error`, beside those of the
    /// picture; NaN counts as an error that is not finite, and a name left out as not measured. Called when the point's
    /// picture of `size` was rendered, with the point's knobs in effect; it may set knobs and render further frames, in
    /// a Frame of its own, and finds its knobs put back afterwards.
    virtual void measure(Gpu& /*gpu*/, glm::uvec2 /*size*/, nlohmann::json& /*error*/) {}

    /// What C++ exercises change apart from shaders needs the scene loaded anew when they are toggled.
    virtual bool reload_on_toggle() const { return false; }

    /// Which knobs change what is loaded, as text: where it differs from what the scene was loaded with, the window
    /// loads it anew.
    virtual std::string load_key() const { return {}; }

    /// What the panel shows of the last frame beside the times, and --timings writes: a line each.
    virtual std::vector<std::string> status() const { return {}; }

    /// What moves, or gathers samples over frames, is drawn without a pause; the window's clock runs from the start.
    virtual bool animated() const { return false; }
};

/// Reads a scene file or wraps a model file, and loads it. Throws InputError. With a budget the need rule chooses for a
/// picture of `size`; what it says is returned.
std::vector<std::string> load_scene(Chapter& chapter, Gpu& gpu, const std::filesystem::path& file,
                                    std::optional<double> budget = {}, glm::uvec2 size = glm::uvec2(0));

/// Records one frame with the knobs' uniforms and macros in place. Frame::end() is left to the caller, also where this
/// throws: what was recorded has to be submitted.
void record(Chapter& chapter, Frame& frame, glm::uvec2 size, float time_s, unsigned seed);

/// Records, submits and waits for one frame.
void render(Chapter& chapter, Frame& frame, glm::uvec2 size, float time_s, unsigned seed);

/// frame.hdr to frame.output: clamped to 1 and sRGB-encoded. Chapters that map tones better do so themselves.
void encode_srgb(Frame& frame);

std::vector<Shot> read_shots(const std::string& chapter);

using MakeChapter = std::function<std::unique_ptr<Chapter>()>;

/// The whole program: options, then a window, a picture or a list. Returns the exit code.
int run_chapter(int argc, char** argv, const char* name, const MakeChapter& make);

}  // namespace lightwalk

#define CHAPTER(Type)                                                                                          \
    int main(int argc, char** argv) {                                                                          \
        return lightwalk::run_chapter(argc, argv, LIGHTWALK_CHAPTER, [] { return std::make_unique<Type>(); }); \
    }
