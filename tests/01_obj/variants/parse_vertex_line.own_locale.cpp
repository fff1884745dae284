// right
#include <clocale>
#include <cmath>
#include <cstdlib>
#include <string>

#include "01_obj/exercises.h"
#include "01_obj/lines.h"

namespace lightwalk::exercise {

// By strtof in a locale of its own, for words of decimal characters alone.
glm::vec3 parse_vertex_line(std::string_view line) {
    static const locale_t plain = newlocale(LC_ALL_MASK, "C", nullptr);
    next_word(line);
    std::vector<float> numbers;
    for (std::string text; !(text = next_value(line)).empty();) {
        char* end = nullptr;
        numbers.push_back(strtof_l(text.c_str(), &end, plain));
        if (text.find_first_not_of("+-.0123456789eE") != text.npos || *end != 0) throw InputError("not a number");
        if (std::isinf(numbers.back())) throw InputError("too large");
    }
    if (numbers.size() < 3 || numbers.size() == 5 || numbers.size() > 7)
        throw InputError("3, 4, 6 or 7 numbers are right");
    return {numbers[0], numbers[1], numbers[2]};
}

}  // namespace lightwalk::exercise
