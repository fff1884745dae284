// Exercise 01.parse_vertex_line: the position on one line of an OBJ file, such as
//     v 0.254714 -0.437146 -0.082668
// Starter: the function reads two numbers and drops the third: models are as flat as paper.
#include <cstdlib>
#include <string>

#include "01_obj/exercises.h"
#include "common/base/error.h"  // InputError

namespace lightwalk::exercise {

// [parse_vertex_line]
// Returns the position on one line of the form `v x y z`, `v x y z w`, `v x y z r g b` or
// `v x y z w r g b`. The values w, r, g and b must be valid numbers; they are ignored.
// Spaces and tabs separate words. A word that begins with # starts a comment, which runs to
// the end of the line.
// A number is decimal, with an optional sign, decimal point and exponent: 1, -.5, +2.5e-3.
// Hexadecimal numbers (0x10), nan and inf are errors. Every number is rounded once, to the
// nearest float, in any locale. A number too small for a float (1e-400) becomes a zero with
// its sign.
// Throws InputError with the reason alone (the caller adds file and line) if a number is
// missing, malformed or too large for a float, or if the count of numbers fits none of the
// four forms.
// [/parse_vertex_line]
glm::vec3 parse_vertex_line(std::string_view line) {
    // 1. Skip the `v`, then read three numbers. std::from_chars (in <charconv>) reads one without looking at the locale
    //    and rounds it correctly. It takes no leading '+', and it does read "nan" and "inf", which you must refuse.
    // 2. What may follow must be numbers too: read all, count them, keep three.
    // 3. Where something is wrong: throw InputError("what is wrong");
    const std::string numbers(line.substr(line.find(' ') + 1));
    char* rest = nullptr;
    const float x = std::strtof(numbers.c_str(), &rest);
    return {x, std::strtof(rest, &rest), 0.0f};
}

}  // namespace lightwalk::exercise
