// Foreign code that reads foreign files, kept where it can do no harm: a process of its own.
#pragma once
#include <cstddef>
#include <functional>
#include <string>

namespace lightwalk {

struct GuardLimits {
    double cpu_s = 10;                ///< of the processor's time; ten times as much on the clock
    size_t memory = size_t{1} << 30;  ///< bytes, in addition to the program's own; includes the result
};

/// For a reader of a file of so many bytes: 10 s and one for each 5 MB, 1 GiB and 40 bytes for each byte.
GuardLimits limits_for(size_t file_bytes);

/// Runs `work` in a copy of this process (fork) with those limits, without output and without files to write to, and
/// returns the bytes that it returns. Warnings (text.h) and exceptions come back: InputError as it is, any other as
/// Failure. Where the copy dies, or goes beyond a limit, throws InputError with one line: "FILE: READER crashed on it
/// (Segmentation fault)". Where progress() of this thread is cancelled meanwhile, the copy is killed, and Cancelled thrown.
/// Within work(), and in the grader's sandbox, it just calls: guards do not nest.
std::string run_guarded(const std::string& file, const std::string& reader, const GuardLimits& limits,
                        const std::function<std::string()>& work);

/// Whether run_guarded() would start a process here and now.
bool guards();

/// From now on work runs in this process, unguarded: for a fuzzer, which wants to see it die.
void stop_guarding();

}  // namespace lightwalk
