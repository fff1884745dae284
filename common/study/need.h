// The need rule: measures which method within an error budget draws a scene at the lowest cost.
#pragma once
#include "common/app/render.h"
#include "common/gpu/frame.h"
#include "common/study/study_plan.h"

namespace lightwalk {

/// Milliseconds of GPU time of the frame that ended last: the sum over all of its passes.
inline double gpu_ms(const Frame& frame) {
    double sum = 0;
    for (const PassTime& pass : frame.times) sum += pass.gpu_ms;
    return sum;
}

/// Milliseconds that the frame just drawn took.
using FrameClock = std::function<double(const Frame&)>;

struct NeedQuestion {
    std::vector<double> budgets;  ///< the greatest mean FLIP allowed
    Picture picture;              ///< the picture to judge and time
    bool crops = false;           ///< draw crops also where whole pictures cost less, if the picture is large enough
    FrameClock clock = gpu_ms;
    std::function<void()> between{};  ///< before each drawn picture; an exception ends the measurement
};

/// For each budget the cheapest of the plan's candidates with an error within it, among those that agree with the
/// chapter's pinned knobs and their own `where`; if there is none, the most accurate one. Sets the last choice's
/// knobs. Before, knobs must be the scene's, and the exercises to judge in use. Returns the output of --explain
/// (docs/study_format.md), one for each budget; pictures are drawn once for all budgets. Throws InputError if no
/// candidate agrees.
std::vector<nlohmann::json> choose_candidates(Chapter& chapter, Gpu& gpu, const StudyPlan& plan,
                                              const NeedQuestion& question);

/// The study.json that compares this knob's choices: the chapter's own for its methods; for a borrowed module, the
/// study that names its kind ("module"). Empty: there is none.
std::filesystem::path study_of(const Chapter& chapter, const KnobBase& knob);

/// Sets the cheapest method with a mean FLIP of at most `budget` in `picture`, as --method auto does, and the knobs
/// that go with it; other settings of the command line stay. Returns a line with the choice and the reason. Throws
/// InputError with a reason if this cannot be measured here; knobs are then unchanged. The exercises to judge must be
/// in use before. `between`: called before each drawn picture; an exception from it ends the choice.
std::string choose_method(Chapter& chapter, Gpu& gpu, KnobBase& method, double budget, const Picture& picture,
                          const std::function<void()>& between = {});

}  // namespace lightwalk
