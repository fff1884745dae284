// Isolation of third-party readers of untrusted files in a process of their own.
#pragma once
#include <cstddef>
#include <functional>
#include <string>

namespace lightwalk {

struct GuardLimits {
    double cpu_s = 10;                ///< CPU seconds; ten times as long in real time
    size_t memory = size_t{1} << 30;  ///< bytes beyond the program's own
};

/// Limits for a file: 10 s plus 1 s per 5 MB, 1 GiB plus 40 bytes per byte.
GuardLimits limits_for(size_t file_bytes);

/// Runs `work` in a forked process with limits, without output or writable files, and returns its result. Warnings
/// (text.h) and InputError are forwarded; other exceptions become Failure. Throws InputError if the process crashes or
/// exceeds a limit, "FILE: READER crashed on it (Segmentation fault)", and Cancelled if this thread's progress() is
/// cancelled. Guards do not nest: within `work`, and in the grader's sandbox, the call is direct.
std::string run_guarded(const std::string& file, const std::string& reader, const GuardLimits& limits,
                        const std::function<std::string()>& work);

bool guards();

/// Disables forking, for fuzzers, which need to observe crashes.
void stop_guarding();

/// Prints one line on stderr for a crash, with exit code 1 if memory ran out. Disabled under sanitizers.
void say_crashes();

}  // namespace lightwalk
