// Check that all invocations of a workgroup execute the same barrier() calls.
#pragma once
#include <cstdint>
#include <span>
#include <string>

namespace lightwalk {

/// GLSL placed before an exercise. barrier() records its position per invocation in `check_barriers_passed`.
/// memoryBarrier() and the like are disabled: drivers that run a workgroup on one thread may synchronise there, which
/// would hide missing barriers. Checks use check_barrier(), which is not recorded. Graded answers cannot use names with
/// this prefix (common/course/check/glsl_answer.py).
std::string traced_barriers();

/// GLSL whose barriers also note races on `array`, a shared array of `count` elements, in the bool `check_raced`: between
/// two barriers one element changed that several invocations named. `text` is the exercise's, in which each element
/// named is noted for `check_stands_for`. The array's declaration comes before `after`, and check_barrier() ends the
/// last interval.
struct Raced {
    std::string before, text, after;
};
Raced traced_races(const std::string& text, const std::string& array, const std::string& type, uint32_t count);

/// Error message for a workgroup's `check_barriers_passed`, by invocation; empty if all agree.
std::string barriers_wrong(std::span<const uint32_t> passed);

inline constexpr const char* barrier_hint =
    "barrier() waits for every invocation of the workgroup: it stands where all come by, outside of each `if` and each "
    "loop that only some of them enter, and before any return that only some of them take";

}  // namespace lightwalk
