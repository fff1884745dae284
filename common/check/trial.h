// Trials: parts of a check that run in the process with student C++.
#pragma once

/// TRIAL("02.record_mist", std::vector<RecordedFrame>, try_record_mist, float red) declares a function that calls an
/// exercise with process-bound objects (frame, device, function) and returns the recording (recorded.h). The check
/// replays and judges it in a process without student code. Declared in tests/NN_name/trials.h, within namespace
/// lightwalk; defined in checks_trial_*.cpp beside it. ./course check calls it directly; the grader in a separate
/// process.
#define TRIAL(id, result, name, ...) result name(__VA_ARGS__)
