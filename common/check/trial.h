// Trials: the part of a check that must run where the student's C++ runs.
#pragma once

/// TRIAL("02.record_mist", std::vector<RecordedFrame>, try_record_mist, float red) declares a function that calls an
/// exercise with objects bound to this process (a frame, a device, a function) and returns the recording as data
/// (recorded.h). It measures nothing: the check replays and judges the recording in a process without student code.
/// Declared in tests/NN_name/trials.h, within namespace lightwalk, and defined in a file checks_trial_*.cpp beside
/// it. ./course check calls it; the grader runs it with the student's code, in a separate process.
#define TRIAL(id, result, name, ...) result name(__VA_ARGS__)
