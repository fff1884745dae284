// Common forms of numbers and corners, evaluated while their end is sought. Uncommon forms are the scanner's.
#pragma once
#include <string_view>

#include "01_obj/fast_parse.h"
#include "01_obj/lines.h"
#include "01_obj/obj.h"

namespace lightwalk {

/// Takes a number such as -12.345 off the text; false, and nothing taken, for any other form.
inline bool take_plain_float(std::string_view& rest, float& value) {
    const char* at = rest.data();
    const char* const end = at + rest.size();
    while (at < end && *at == ' ') ++at;
    const bool negative = at < end && *at == '-';
    at += negative;
    uint64_t digits = 0;
    const auto take_digits = [&] {
        const char* const first = at;
        for (; at < end && is_digit(*at); ++at) digits = 10 * digits + static_cast<uint64_t>(*at - '0');
        return static_cast<size_t>(at - first);
    };
    const size_t whole = take_digits();
    size_t decimals = 0;
    if (at < end && *at == '.') {
        ++at;
        decimals = take_digits();
    }
    if (whole == 0 || whole + decimals > 15 || (at < end && !is_space(*at))) return false;
    if (!round_quotient(digits, static_cast<unsigned>(decimals), negative, value)) return false;
    rest.remove_prefix(static_cast<size_t>(at - rest.data()));
    return true;
}

/// Takes a corner of positive indices, such as 7/8/9, likewise.
inline bool take_plain_corner(std::string_view& rest, Corner& corner) {
    const char* at = rest.data();
    const char* const end = at + rest.size();
    while (at < end && *at == ' ') ++at;
    const auto take_index = [&](uint32_t& index) {
        const char* const first = at;
        uint32_t number = 0;
        for (; at < end && is_digit(*at); ++at) number = 10 * number + static_cast<uint32_t>(*at - '0');
        index = number - 1;
        return at - first <= 8 && number > 0;
    };
    const auto take_slash = [&] {
        const bool there = at < end && *at == '/';
        at += there;
        return there;
    };
    if (!take_index(corner.position)) return false;
    if (take_slash()) {
        if (at == end || (*at != '/' && !take_index(corner.uv))) return false;
        if (take_slash() && !take_index(corner.normal)) return false;
    }
    if (at < end && !is_space(*at)) return false;
    rest.remove_prefix(static_cast<size_t>(at - rest.data()));
    return true;
}

}  // namespace lightwalk
