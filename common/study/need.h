// The need rule: the cheapest way to draw a scene whose error is within a budget, by measuring.
#pragma once
#include "common/app/render.h"
#include "common/study/gpu_time.h"
#include "common/study/study_plan.h"

namespace lightwalk {

/// Milliseconds that the frame just drawn took.
using FrameClock = std::function<double(const Frame&)>;

struct NeedQuestion {
    std::vector<double> budgets;  ///< the greatest mean FLIP allowed
    Picture picture;              ///< whose error and time count
    bool crops = false;           ///< draw crops also where whole pictures cost less, if the picture is large enough
    FrameClock clock = gpu_ms;
    std::function<void()> between{};  ///< before each picture that is drawn; what it throws ends the measurement
};

/// For each budget the cheapest of the plan's candidates whose error is at most the budget, of those that agree with
/// the chapter's pinned knobs and their own `where`; where none is within it, the most accurate one. The last choice's
/// knobs are set. Before, knobs are the scene's, and the exercises those that are to judge. Returns what
/// docs/study_format.md says of --explain, one for each budget; what was drawn for one is not drawn again for the next.
/// Throws InputError where no candidate agrees.
std::vector<nlohmann::json> choose_candidates(Chapter& chapter, Gpu& gpu, const StudyPlan& plan,
                                              const NeedQuestion& question);

}  // namespace lightwalk
