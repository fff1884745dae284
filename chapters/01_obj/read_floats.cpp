// Reads the numbers of a line. A file of its own: the reference of 01.parse_vertex_line calls it, and checks link that.
#include "01_obj/fast_parse.h"
#include "01_obj/lines.h"
#include "01_obj/scan.h"
#include "common/base/text.h"

namespace lightwalk {

float float_or_throw(std::string_view word) {
    float value = 0.0f;
    switch (parse_float(word, value)) {
        case FloatStatus::ok:
            break;
        case FloatStatus::not_a_number:
            throw InputError("{} is not a number such as -1.5 or 2e-3", shown(word));
        case FloatStatus::too_large:
            throw InputError("{} is too large for a float, at most 3.4028e38", shown(word));
    }
    return value;
}

int read_floats(std::string_view rest, int least, int most, float* values, std::string_view usage) {
    int count = 0;
    for (;; ++count) {
        const std::string_view word = next_value(rest);
        if (word.empty()) break;
        if (count == most) throw InputError("too many numbers, expected {}", usage);
        values[count] = float_or_throw(word);
    }
    if (count < least) throw InputError("{} number{}, expected {}", count, count == 1 ? "" : "s", usage);
    return count;
}

}  // namespace lightwalk
