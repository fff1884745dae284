#include <charconv>
#include <cmath>

#include "01_obj/exercises.h"
#include "01_obj/lines.h"

namespace lightwalk::solution {
namespace {

float read_number(std::string_view word) {
    // std::from_chars takes no plus sign, and does take "nan" and "inf".
    const std::string_view digits = word.substr(word.starts_with('+') && !word.starts_with("+-") ? 1u : 0u);
    float value = 0.0f;
    const auto [rest, error] = std::from_chars(digits.begin(), digits.end(), value);
    if (error == std::errc::invalid_argument || rest != digits.end() || std::isnan(value))
        throw InputError("{} is not a number such as -1.5 or 2e-3", shown(word));
    const bool negative = digits.starts_with('-');
    if (error == std::errc::result_out_of_range && underflows(digits.substr(negative ? 1u : 0u)))
        return negative ? -0.0f : 0.0f;
    if (error == std::errc::result_out_of_range || std::isinf(value))
        throw InputError("{} is too large for a float, at most 3.4028e38", shown(word));
    return value;
}

}  // namespace

glm::vec3 parse_vertex_line(std::string_view line) {
    next_word(line);  // the v
    glm::vec3 position(0.0f);
    int count = 0;
    for (std::string_view word; !(word = next_value(line)).empty(); ++count) {
        const float number = read_number(word);
        if (count < 3) position[count] = number;
    }
    if (count != 3 && count != 4 && count != 6 && count != 7)
        throw InputError("{} numbers, expected v x y z, optionally followed by w, r g b, or both", count);
    return position;
}

}  // namespace lightwalk::solution
