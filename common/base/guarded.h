// Foreign code that reads foreign files, kept where it can do no harm: a process of its own.
#pragma once
#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <string_view>

namespace lightwalk {

struct GuardLimits {
    double cpu_s = 10;                ///< of the processor's time; ten times as much on the clock
    size_t memory = size_t{1} << 30;  ///< bytes, in addition to the program's own; the result takes as many at most
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

/// Receiver of a reader's result.
struct GuardReply {
    virtual ~GuardReply() = default;
    virtual void append(std::string_view bytes) = 0;
};

/// A reader that knows nothing but its input: its process need not be a copy of the present moment.
using GuardReader = void (*)(std::string_view input, GuardReply& reply);

/// Parts of one input.
using GuardInput = std::initializer_list<std::string_view>;

struct GuardJob {
    std::string file, name;  ///< for messages
    GuardReader read;
};

/// As run_guarded(), in a process that is kept for the next file: a copy of a large process takes 4 to 50 ms. It is
/// replaced after a crash, a limit and a Failure. `receive` gets the result, which is gone afterwards.
void read_guarded(const GuardJob& reader, const GuardLimits& limits, const GuardInput& input,
                  const std::function<void(std::string_view)>& receive);

/// Starts the process of read_guarded(), while this one is small and quickly copied.
void prepare_guard();

/// Whether run_guarded() would start a process here and now.
bool guards();

/// From now on work runs in this process, unguarded: for a fuzzer, which wants to see it die.
void stop_guarding();

}  // namespace lightwalk
