// Protection against student C++ that crashes or hangs.
#pragma once
#include <functional>
#include <string>

#include "common/base/error.h"

namespace lightwalk {

/// Processor time of a call: $LIGHTWALK_TIMEOUT_S, default 5 s.
int call_limit_s();

/// Time of a call by the clock, which ends only one that sleeps or a stopped process.
int most_wait_s();

/// Ends the program with code 1 after a crash or time-out, with a message to `report`. Off under sanitizers.
void guard_calls(std::function<void(const std::string& message)> report);

/// Sets the call's name for messages and starts the timer; "" stops it.
void guard_call(std::string what);

const std::string& guarded();

/// A process running student C++ crashed, timed out or sent invalid data. The text is a full sentence.
struct Lost : Failure {
    using Failure::Failure;
};

}  // namespace lightwalk
