// Number parser that reads eight characters at a time. Uncommon forms are left to parse_float().
#pragma once
#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <string_view>

#include "01_obj/lines.h"

namespace lightwalk {

// All of these may read up to 32 bytes past `at`; a zero byte ends every number.

/// The next eight characters, the first one in the lowest byte.
inline uint64_t load_eight(const char* at) {
    static_assert(std::endian::native == std::endian::little);
    uint64_t word;
    std::memcpy(&word, at, sizeof word);
    return word;
}

inline constexpr uint64_t zeros = 0x3030303030303030ull;  // '0' eight times
inline constexpr std::array<uint32_t, 9> whole_powers = {1, 10, 100, 1000, 10000, 100000, 1000000, 10000000, 100000000};

inline bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// How many of the eight characters, from the first on, are decimal digits.
inline unsigned leading_digits(uint64_t word) {
    // '0' to '9' become 0 to 9, everything else 10 or more; adding 0x76 sets its top bit. Only a non-digit carries
    // into the next byte, and bytes behind the first non-digit do not matter.
    const uint64_t value = word ^ zeros;
    const uint64_t other = (value | (value + 0x7676767676767676ull)) & 0x8080808080808080ull;
    return static_cast<unsigned>(std::countr_zero(other)) / 8;
}

/// The number that eight digit values (not characters) write, the first one in the lowest byte: neighbours are joined
/// to pairs, fours and the whole, as in D. Lemire, "Quickly parsing eight digits" (2018).
inline uint32_t join_digits(uint64_t digits) {
    digits = (digits * 10 + (digits >> 8)) & 0x00ff00ff00ff00ffull;
    digits = (digits * 100 + (digits >> 16)) & 0x0000ffff0000ffffull;
    return static_cast<uint32_t>(digits * 10000 + (digits >> 32));
}

/// The first `count` of the characters, 1 to 8, as a number.
inline uint32_t first_digits(uint64_t word, unsigned count) { return join_digits((word ^ zeros) << (64 - 8 * count)); }

/// digits / 10^decimals, correctly rounded; false where that needs more care. `digits` is below 10^15, `decimals`
/// below 16.
inline bool round_quotient(uint64_t digits, unsigned decimals, bool negative, float& value) {
    // Powers of ten to 10^22 are exact in double precision, and so is an integer below 2^53: one division rounds the
    // quotient correctly (W. Clinger, "How to read floating point numbers accurately", 1990).
    static constexpr std::array<double, 16> powers = {1e0, 1e1, 1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                                      1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};
    const double rounded = static_cast<double>(static_cast<int64_t>(digits)) / powers[decimals];
    // Rounding twice, to double and then to float, goes wrong only where the double lies half-way between two floats:
    // then the decimal may have lain on either side. Every such quotient is normal as a float, or zero.
    constexpr uint64_t below_float = (uint64_t{1} << 29) - 1, half_way = uint64_t{1} << 28;
    if ((std::bit_cast<uint64_t>(rounded) & below_float) == half_way) return false;
    value = std::bit_cast<float>(std::bit_cast<uint32_t>(static_cast<float>(rounded)) | uint32_t{negative} << 31);
    return true;
}

/// `whole` digits, the point and `decimals` digits, eight digits at most: without the point they are one number.
inline const char* fast_short_float(const char* at, unsigned whole, unsigned decimals, bool negative, float& value) {
    const uint64_t front = (load_eight(at) ^ zeros) << (64 - 8 * whole) >> 8 * decimals;
    const uint64_t behind = (load_eight(at + whole + 1) ^ zeros) << (64 - 8 * decimals);
    return round_quotient(join_digits(front | behind), decimals, negative, value) ? at + whole + 1 + decimals : nullptr;
}

/// A decimal number -d.d with 1 to 7 digits before the point and up to 15 in all, without exponent, and correctly
/// rounded. Returns its end, or null where the text has another form or rounding needs more care.
inline const char* fast_float(const char* at, float& value) {
    const bool negative = *at == '-';
    at += negative;
    const uint64_t word = load_eight(at);
    const unsigned whole = leading_digits(word);
    if (whole - 1 > 6) return nullptr;
    uint64_t digits = first_digits(word, whole);
    unsigned decimals = 0;
    at += whole;
    if (*at == '.') {
        uint64_t behind = load_eight(++at);
        decimals = leading_digits(behind);
        if (decimals == 0) return nullptr;
        if (whole + decimals <= 8) return fast_short_float(at - 1 - whole, whole, decimals, negative, value);
        digits = digits * whole_powers[decimals] + first_digits(behind, decimals);
        at += decimals;
        if (decimals == 8) {
            behind = load_eight(at);
            const unsigned more = leading_digits(behind);
            if (whole + 8 + more > 15) return nullptr;
            if (more > 0) digits = digits * whole_powers[more] + first_digits(behind, more);
            decimals += more;
            at += more;
        }
    }
    return round_quotient(digits, decimals, negative, value) ? at : nullptr;
}

/// An integer from 1 with up to 7 digits. Returns its end, or null where the text has another form.
inline const char* fast_index(const char* at, uint32_t& value) {
    const uint64_t word = load_eight(at);
    const unsigned count = leading_digits(word);
    if (count == 0 || count == 8) return nullptr;
    value = first_digits(word, count);
    return value == 0 ? nullptr : at + count;
}

enum class FloatStatus { ok, not_a_number, too_large };

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
