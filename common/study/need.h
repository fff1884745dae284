// The need rule: the cheapest way to draw a scene whose error is within a budget, by measuring.
#pragma once
#include "common/app/render.h"
#include "common/study/study_plan.h"

namespace lightwalk {

struct NeedQuestion {
    double budget = 0;   ///< the greatest mean FLIP allowed
    Picture picture;     ///< whose error and time count
    bool crops = false;  ///< draw crops also where whole pictures cost less, as far as the picture is large enough
};

/// Sets the knobs of the cheapest of the plan's candidates whose error is at most the budget, of those that agree with
/// the chapter's pinned knobs and their own `where`; where none is within it, of the most accurate one. Knobs are the
/// scene's before, and the exercises those that are to judge. Returns what docs/study_format.md says of --explain.
/// Throws InputError where no candidate agrees.
nlohmann::json choose_candidate(Chapter& chapter, Gpu& gpu, const StudyPlan& plan, const NeedQuestion& question);

}  // namespace lightwalk
