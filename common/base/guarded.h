// Sandboxing of third-party readers of untrusted files in a separate process.
#pragma once
#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <string_view>

namespace lightwalk {

struct GuardLimits {
    double cpu_s = 10;                ///< CPU seconds; ten times as long in real time
    size_t memory = size_t{1} << 30;  ///< bytes beyond the program's own; also bounds the result
};

/// Limits for a file: 10 s plus 1 s per 5 MB, 1 GiB plus 40 bytes per byte.
GuardLimits limits_for(size_t file_bytes);

/// Runs `work` in a forked process with limits, without output or writable files, and returns its result. Warnings
/// (text.h) and InputError are forwarded; other exceptions become Failure. Throws InputError if the process crashes or
/// exceeds a limit, "FILE: READER crashed on it (Segmentation fault)", and Cancelled if this thread's progress() is
/// cancelled. Guards do not nest: within `work`, and in the grader's sandbox, the call is direct.
std::string run_guarded(const std::string& file, const std::string& reader, const GuardLimits& limits,
                        const std::function<std::string()>& work);

struct GuardReply {
    virtual ~GuardReply() = default;
    virtual void append(std::string_view bytes) = 0;
};

/// Reader that depends only on its input, so that a process forked earlier can run it.
using GuardReader = void (*)(std::string_view input, GuardReply& reply);

/// Parts of a reader's input, concatenated.
using GuardInput = std::initializer_list<std::string_view>;

struct GuardJob {
    std::string file, name;
    GuardReader read;
};

/// run_guarded() in a reused process: forking takes 4 to 50 ms. `receive` gets the result, valid during the call.
void read_guarded(const GuardJob& reader, const GuardLimits& limits, const GuardInput& input,
                  const std::function<void(std::string_view)>& receive);

/// Forks the process of read_guarded() early, while this process is small.
void prepare_guard();

bool guards();

/// Disables forking, for fuzzers, which need to observe crashes.
void stop_guarding();

}  // namespace lightwalk
