// Whether all invocations of a workgroup come to every barrier() together.
#pragma once
#include <cstdint>
#include <span>
#include <string>

namespace lightwalk {

/// GLSL placed before an exercise. Each later barrier() records in `check_barriers_passed` that this invocation
/// passed it, and where. memoryBarrier() and its kind do nothing: they order writes and do not wait, but software
/// that runs a workgroup on one thread may wait there too, and a wrong answer would pass by accident. A check waits
/// with check_barrier(), which is not recorded. Graded answers have no names with this prefix
/// (common/course/check/glsl_answer.py).
std::string traced_barriers();

/// The fault in `check_barriers_passed` of a workgroup's invocations, by index; empty if all passed the same barriers
/// in the same order.
std::string barriers_wrong(std::span<const uint32_t> passed);

/// For a barriers_wrong().
inline constexpr const char* barrier_hint =
    "barrier() waits for every invocation of the workgroup: it stands where all come by, outside of each `if` and each "
    "loop that only some of them enter, and before any return that only some of them take";

}  // namespace lightwalk
