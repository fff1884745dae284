// Exercise 01.parse_vertex_line: one line of an OBJ file, such as
//     v 0.254714 -0.437146 -0.082668
// becomes a point. As it stands this reads the first two numbers and loses the third: models are as flat as paper.
#include <cstdlib>
#include <string>

#include "01_obj/exercises.h"
#include "common/base/error.h"  // InputError

namespace lightwalk::exercise {

// [parse_vertex_line]
// The position on a line `v x y z`, `v x y z w`, `v x y z r g b` or `v x y z w r g b`; w and the colour must be numbers
// and are dropped. Words are parted by spaces and tabs; a word that begins with # begins a comment, to the line's end.
// A number is decimal, with a point and perhaps a sign and an exponent: 1, -.5, +2.5e-3; neither 0x10 nor nan nor inf.
// Every one is rounded once, to the nearest float, in any locale. Too small a number (1e-400) is a zero with its sign.
// Throws InputError with the reason alone (the caller adds file and line) where a number is missing, one too many, no
// number, or too large for a float.
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
