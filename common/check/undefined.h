// Operations whose result GLSL leaves open: found by giving them other results, on any driver.
#pragma once
#include <limits>
#include <string>

namespace lightwalk {

/// What an operation without a defined result gives in turn. A function that is right does not depend on it.
inline constexpr float undefined_results[] = {
    0.0f, 1.0f, -1.0f, 7.5f, -1e30f, 1e30f, std::numeric_limits<float>::quiet_NaN()};

/// GLSL with every division and index replaced by a function of undefined_glsl(), which does the same where the result
/// is defined. #includes must be resolved before. Where it cannot follow the text (a macro with half an expression)
/// what comes out may not compile.
std::string instrumented(const std::string& glsl);

/// The functions that instrumented text, which comes behind it, calls; and macros that put others in the place of pow,
/// normalize, sqrt, log, acos, ... . Where a result is not defined they give `undefined_result`, and note
/// the first such operation in `undefined_what` (0: none) with its operands in `undefined_a` and `undefined_b`.
std::string undefined_glsl();

/// True where what was noted is wrong whatever becomes of the result.
bool counts_always(int what);

/// "divides A by 0", with A and B for the operands of what was noted; empty for a number that notes nothing.
std::string undefined_template(int what);
/// "divides 3 by 0", for what was noted.
std::string undefined_words(int what, double a, double b);

}  // namespace lightwalk
