#include "01_obj/exercises.h"
#include "01_obj/lines.h"
#include "01_obj/scan.h"

namespace lightwalk::solution {

glm::vec3 parse_vertex_line(std::string_view line) {
    next_word(line);  // the v
    float values[7];
    // read_floats takes word by word and hands each to std::from_chars; see parse_float().
    const int count = read_floats(line, 3, 7, values, "v x y z, optionally followed by w, r g b, or both");
    if (count == 5) throw InputError("5 numbers, expected v x y z, optionally followed by w, r g b, or both");
    return {values[0], values[1], values[2]};
}

}  // namespace lightwalk::solution
