// Exercise 01.parse_vertex_line: one line of an OBJ file, such as
//     v 0.254714 -0.437146 -0.082668
// becomes a point. As it stands this reads the first two numbers and loses the third: models are as flat as paper.
#include <cstdlib>
#include <string>

#include "01_obj/exercises.h"

namespace lightwalk::exercise {

glm::vec3 parse_vertex_line(std::string_view line) {
    // 1. Skip the `v`, then read three numbers. std::from_chars (in <charconv>) reads one without looking at the locale
    //    and rounds it correctly. It takes no leading '+', and it does read "nan" and "inf", which you must refuse.
    // 2. A w, or a colour r g b, or both, may follow: check that they are numbers, then forget them.
    // 3. Where something is wrong, throw InputError("what is wrong"); the caller adds the file and the line.
    // 4. Too small a number (1e-400) is a zero with its sign; one too large for a float is an error.
    const std::string numbers(line.substr(line.find(' ') + 1));
    char* rest = nullptr;
    const float x = std::strtof(numbers.c_str(), &rest);
    return {x, std::strtof(rest, &rest), 0.0f};
}

}  // namespace lightwalk::exercise
