// What a student's C++ does to the program that checks it: crashes, and calls that never return.
#pragma once
#include <functional>
#include <string>

namespace lightwalk {

/// Of a call: 5, or $LIGHTWALK_CALL_LIMIT_S.
int call_limit_s();

/// From here on a call that crashes or does not return within call_limit_s() ends the program with code 1, after
/// `report` has been told what happened: "parse_face("f 1 2") crashed: ...". Not under sanitizers, which say more.
void guard_calls(std::function<void(const std::string& message)> report);

/// What is called next, as it is told: "parse_face("f 1 2")". Starts the clock; "" stops it.
void guard_call(std::string what);

/// What is being called; "" where nothing is.
const std::string& guarded();

}  // namespace lightwalk
