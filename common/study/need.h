// The need rule: measures which method within an error budget draws a scene at the lowest cost.
#pragma once
#include "common/app/render.h"
#include "common/study/gpu_time.h"
#include "common/study/study_plan.h"

namespace lightwalk {

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

}  // namespace lightwalk
