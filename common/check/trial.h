// Trials: the part of a check that must run where the student's C++ runs.
#pragma once

/// TRIAL("02.record_mist", std::vector<RecordedFrame>, try_record_mist, float red) declares a function that calls an
/// exercise with what cannot be handed to another process (a frame, a device, a function) and returns what it recorded
/// as data (recorded.h). It measures nothing: the check replays and judges it where no code of a student's is. It is
/// declared in tests/NN_name/trials.h, within namespace lightwalk, and defined in a file checks_trial_*.cpp beside it.
/// ./course check calls it; the grader has it run with the student's code, in a process of its own.
#define TRIAL(id, result, name, ...) result name(__VA_ARGS__)
