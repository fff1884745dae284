// The need rule while a chapter runs: the cheapest method of a module, by measuring the picture that is shown.
#pragma once
#include "common/app/render.h"

namespace lightwalk {

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
