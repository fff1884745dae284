// Detection of GLSL operations with undefined results, on any driver: substituted results must not matter.
#pragma once
#include <limits>
#include <string>

namespace lightwalk {

/// Substitutes for undefined results. Correct functions do not depend on them.
inline constexpr float undefined_results[] = {
    0.0f, 1.0f, -1.0f, 7.5f, -1e30f, 1e30f, std::numeric_limits<float>::quiet_NaN()};

/// GLSL with every division and index replaced by a function of undefined_glsl(), equal where defined. Includes must be
/// expanded. Unparsable text, such as macros with partial expressions, may not compile afterwards.
std::string instrumented(const std::string& glsl);

/// Functions called by instrumented text, and macros that replace pow, normalize, sqrt, log, acos, …; to be placed
/// before it. Undefined results become `undefined_result`; the first such operation is noted in `undefined_what` (0:
/// none), `undefined_a` and `undefined_b`.
std::string undefined_glsl();

/// True if the operation is an error even when its result is unused.
bool counts_always(int what);

/// "divides A by 0", with A and B for the operands; empty if `what` records nothing.
std::string undefined_template(int what);
/// "divides 3 by 0".
std::string undefined_words(int what, double a, double b);

}  // namespace lightwalk
