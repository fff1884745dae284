// wrong: "v 1 2 3 # three"
#include <charconv>
#include <cmath>
#include <string>

#include "01_obj/exercises.h"
#include "01_obj/lines.h"

namespace lightwalk::exercise {

glm::vec3 parse_vertex_line(std::string_view line) {
    next_word(line);
    glm::vec3 point(0.0f);
    int count = 0;
    for (std::string_view word; !(word = next_word(line)).empty(); ++count) {
        if (word[0] == '+') word.remove_prefix(1);
        float value = 0.0f;
        const auto [stop, error] = std::from_chars(word.data(), word.data() + word.size(), value);
        if (stop != word.data() + word.size() || error == std::errc::invalid_argument) throw InputError("not a number");
        if (error == std::errc::result_out_of_range) {
            double wide = 0.0;
            std::from_chars(word.data(), word.data() + word.size(), wide);
            if (std::abs(wide) > 1.0) throw InputError("too large");
            value = word[0] == '-' ? -0.0f : 0.0f;
        }
        if (!std::isfinite(value)) throw InputError("not a number");
        if (count < 3) point[count] = value;
    }
    if (count != 3 && count != 4 && count != 6 && count != 7) throw InputError("3, 4, 6 or 7 numbers are right");
    return point;
}

}  // namespace lightwalk::exercise
