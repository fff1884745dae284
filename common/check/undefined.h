// Operations with results undefined in GLSL: found by substituting other results, on any driver.
#pragma once
#include <limits>
#include <string>

namespace lightwalk {

/// Substitute results of an undefined operation. A correct function does not depend on them.
inline constexpr float undefined_results[] = {
    0.0f, 1.0f, -1.0f, 7.5f, -1e30f, 1e30f, std::numeric_limits<float>::quiet_NaN()};

/// GLSL with every division and index replaced by a function of undefined_glsl() that agrees wherever the result is
/// defined. #includes must be resolved before. Unparsable text, such as a macro with half an expression, may yield
/// GLSL that does not compile.
std::string instrumented(const std::string& glsl);

/// The functions that instrumented text, which comes behind it, calls; and macros that put others in the place of pow,
/// normalize, sqrt, log, acos, ... . Where a result is not defined they give `undefined_result`, and note
/// the first such operation in `undefined_what` (0: none) with its operands in `undefined_a` and `undefined_b`.
std::string undefined_glsl();

/// True if the operation is wrong even when its result is unused.
bool counts_always(int what);

/// "divides A by 0", with A and B for the operands; empty for a number that records nothing.
std::string undefined_template(int what);
/// "divides 3 by 0", for a recorded operation.
std::string undefined_words(int what, double a, double b);

}  // namespace lightwalk
