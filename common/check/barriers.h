// Whether all invocations of a workgroup come to every barrier() together.
#pragma once
#include <cstdint>
#include <span>
#include <string>

namespace lightwalk {

/// GLSL that stands before an exercise. Behind it each barrier() notes in `check_barriers_passed` that this invocation
/// has come by, and where; and memoryBarrier(), memoryBarrierShared() and their like do nothing. They order what one
/// invocation writes and wait for nobody, but software that runs a workgroup on one thread may wait there as well, and
/// an answer that has them in a barrier's place would be right by accident. A check waits with check_barrier(), which
/// is not noted. No answer that is graded has names with this beginning (common/course/check/glsl_answer.py).
std::string traced_barriers();

/// What is wrong with `check_barriers_passed` of a workgroup's invocations, by their index; empty where all have come
/// to the same barriers in the same order.
std::string barriers_wrong(std::span<const uint32_t> passed);

/// For a barriers_wrong().
inline constexpr const char* barrier_hint =
    "barrier() waits for every invocation of the workgroup: it stands where all come by, outside of each `if` and each "
    "loop that only some of them enter, and before any return that only some of them take";

}  // namespace lightwalk
