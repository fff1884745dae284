// Decimal text to the nearest float: the result of strtof in the C locale, but faster and without a locale.
#pragma once
#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <string_view>

namespace lightwalk {

enum class FloatStatus { ok, not_a_number, too_large };

/// True where a number that does not fit is so small rather than so large: the power of ten of its first digit.
inline bool underflows(std::string_view number) {
    const size_t e = number.find_first_of("eE");
    const std::string_view digits = number.substr(0, e);
    const size_t first = digits.find_first_of("123456789");
    if (first == digits.npos) return true;
    const size_t point = std::min(digits.find('.'), digits.size());
    int64_t exponent = 0;
    if (e != number.npos) {
        const bool negative = number[e + 1] == '-';
        const char* begin = number.data() + e + 1 + (number[e + 1] == '-' || number[e + 1] == '+');
        if (std::from_chars(begin, number.data() + number.size(), exponent).ec != std::errc()) return negative;
        if (negative) exponent = -exponent;
    }
    return exponent < (first < point ? -static_cast<int64_t>(point - first) : static_cast<int64_t>(first - point));
}

/// A whole word, [+-]digits[.digits][e[+-]digits], correctly rounded (to nearest, ties to even) as by strtof. Too small
/// a number becomes a subnormal or a signed zero; one beyond the largest float is too_large; nan, inf, hexadecimal and
/// a decimal comma are not_a_number.
inline FloatStatus parse_float(std::string_view word, float& value) {
    std::string_view digits = word;
    if (!digits.empty() && (digits[0] == '-' || digits[0] == '+')) digits.remove_prefix(1);
    // from_chars also reads "inf" and "nan", and a second sign.
    if (digits.empty() || !(digits[0] == '.' || (digits[0] >= '0' && digits[0] <= '9')))
        return FloatStatus::not_a_number;
    const char* const end = digits.data() + digits.size();
    const auto [stop, error] = std::from_chars(digits.data(), end, value);
    if (error == std::errc::invalid_argument || stop != end) return FloatStatus::not_a_number;
    if (error == std::errc::result_out_of_range) {
        if (!underflows(digits)) return FloatStatus::too_large;
        value = 0.0f;
    }
    if (value > 3.402823466e38f) return FloatStatus::too_large;
    if (word[0] == '-') value = -value;
    return FloatStatus::ok;
}

}  // namespace lightwalk
