// wrong: "v 1.5 1234.5 0.25"
#include <cmath>
#include <cstdlib>
#include <string>

#include "01_obj/exercises.h"
#include "01_obj/lines.h"

namespace lightwalk::exercise {

glm::vec3 parse_vertex_line(std::string_view line) {
    next_word(line);
    glm::vec3 point(0.0f);
    int count = 0;
    for (std::string_view word; !(word = next_value(line)).empty(); ++count) {
        if (word[0] == '+') word.remove_prefix(1);
        const std::string text(word);
        if (text.find_first_not_of("+-.0123456789eE") != text.npos) throw InputError("not a number");
        char* stop = nullptr;
        const float value = std::strtof(text.c_str(), &stop);
        if (*stop || !std::isfinite(value)) throw InputError("not a number, or too large");
        if (count < 3) point[count] = value;
    }
    if (count != 3 && count != 4 && count != 6 && count != 7) throw InputError("3, 4, 6 or 7 numbers are right");
    return point;
}

}  // namespace lightwalk::exercise
