// Guard against student C++ that crashes or never returns.
#pragma once
#include <functional>
#include <string>

namespace lightwalk {

/// Of a call: $LIGHTWALK_TIMEOUT_S, else 5.
int call_limit_s();

/// From here on, a call that crashes or does not return within call_limit_s() ends the program with code 1, after a
/// message to `report`: "parse_face("f 1 2") crashed: ...". Disabled under sanitizers, which report more.
void guard_calls(std::function<void(const std::string& message)> report);

/// Names the next call for messages: "parse_face("f 1 2")". Starts the clock; "" stops it.
void guard_call(std::string what);

/// The current call; "" if none.
const std::string& guarded();

}  // namespace lightwalk
