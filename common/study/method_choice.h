// The need rule while a chapter runs: the cheapest method of a module, by measuring the picture that is shown.
#pragma once
#include "common/app/render.h"

namespace lightwalk {

/// The study.json that compares what this knob chooses from: the chapter's own for its methods, and for those of a module
/// that another chapter teaches the one that names the module's kind ("module"). Empty: there is none.
std::filesystem::path study_of(const Chapter& chapter, const KnobBase& knob);

/// Sets the cheapest method whose mean FLIP in `picture` is at most `budget`, as --method auto does, and the knobs that go
/// with it; what the command line has set stays, but for the method itself. Returns a line that says which and why. Throws
/// InputError with a line that says why this cannot be measured here; all knobs are then as they were. The exercises that
/// are to judge are in use before. `between`: called before each picture that is drawn; what it throws ends all.
std::string choose_method(Chapter& chapter, Gpu& gpu, KnobBase& method, double budget, const Picture& picture,
                          const std::function<void()>& between = {});

}  // namespace lightwalk
