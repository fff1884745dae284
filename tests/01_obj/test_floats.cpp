// Every float must be the nearest one: bit-equal to strtof.
#include <cmath>
#include <cstdio>
#include <limits>
#include <random>

#include "01_obj/fast_parse.h"
#include "01_obj/truth.h"
#include "catch.h"

using namespace lightwalk;

namespace {

// All readers, against the truth. The fast ones may decline.
void check_number(const std::string& text) {
    const float right = truth::nearest_float(text);
    float value = 0.0f;
    const FloatStatus status = parse_float(text, value);
    if (std::isinf(right)) {
        if (status != FloatStatus::too_large) FAIL("parse_float accepted " << text);
    } else if (status != FloatStatus::ok || truth::ulps(value, right) != 0) {
        FAIL("parse_float(" << text << ") gave " << value << ", expected " << right);
    }
    std::string padded = text + " ";
    padded.append(64, '\0');
    const char* end = fast_float(padded.data(), value);
    if (end == padded.data() + text.size() && truth::ulps(value, right) != 0)
        FAIL("fast_float(" << text << ") gave " << value << ", expected " << right);
}

std::string print(const char* format, int precision, double value) {
    char text[512];
    std::snprintf(text, sizeof text, format, precision, value);
    return text;
}

}  // namespace

TEST_CASE("floats: hard cases are the nearest float") {
    for (const char* text :
         {"0", "-0", "0.0", "-0.000000", "1", "+1.5", "1.", ".5", "-.5", "1e5", "1E-5", "16777217", "16777219",
          "16777217.0", "16777216.999999999999999999", "16777217.000000000000000001", "8388609.5", "8388608.5",
          "1e-400", "-1e-400", "1e-45", "7e-46", "7.0064923216240853e-46", "7.0064923216240854e-46", "1.4e-45",
          "1.17549435e-38", "1.1754942e-38", "1.17549428e-38", "1.1754943157898258e-38", "3.4028234663852886e38",
          "3.4028235677973366e38", "3.4028235677973365e38", "3.4028235677973367e38",
          "340282346638528859811704183484516925440", "340282356779733661637539395458142568447",
          "340282356779733661637539395458142568448", "1e39", "-1e39", "1e400", "1e99999999999999999999",
          "1e-99999999999999999999", "0e99999999999", "0.000000000000000000000000000000000001e40",
          "100000000000000000000000000000000000000000e-10", "0.100000001490116119384765625", "0.10000000149011612",
          "123456789012345678901234567890", "0.1234567890123456789012345678901234567890", "9007199254740993",
          "1234567.12345678", "1234567.123456789", "0.12345678901234", "0.123456789012345", "5960464477539062.5e-23",
          // 16 to 19 digits beside the middle of two floats: a quotient of doubles rounds to the wrong one.
          "96.85794448852539", "983.86898803710937", "926.956268310546876", "6322.683837890625001"})
        check_number(text);
}

TEST_CASE("floats: what is no number, or none for a position") {
    for (const char* text :
         {"",    "-",   "+",   ".",   "-.",   "e5",       "1e",   "1e+", "1,5", "1.5.2", "--1",     "+-1",
          "-+1", "nan", "NaN", "inf", "-inf", "infinity", "0x10", "1f",  "1 ",  "1_000", "\xC2\xBD"}) {
        float value;
        CHECK(parse_float(text, value) == FloatStatus::not_a_number);
    }
    float value;
    CHECK(parse_float("3.41e38", value) == FloatStatus::too_large);
}

TEST_CASE("floats: a million random ones and the points half-way between neighbours") {
    std::mt19937 random(1);
    for (int i = 0; i < 200000; ++i) {
        const float x = std::bit_cast<float>(static_cast<uint32_t>(random()));
        if (!std::isfinite(x)) continue;
        check_number(print("%.*e", static_cast<int>(random() % 18), static_cast<double>(x)));
        const float next = std::nextafter(x, std::numeric_limits<float>::infinity());
        if (i % 8 == 0 && std::isfinite(next)) {
            // Exact: a double holds the sum, and its decimal expansion ends within 200 digits.
            const std::string half_way = print("%.*e", 200, 0.5 * (static_cast<double>(x) + static_cast<double>(next)));
            check_number(half_way);
            std::string more = half_way;
            more[more.find('e') - 1] = '1';
            check_number(more);
        }
        // Typical numbers in files.
        const double y = (static_cast<double>(random()) / 2147483648.0 - 1.0) * std::pow(10.0, random() % 6);
        for (int decimals : {3, 4, 5, 6, 7, 8, 9, 12}) check_number(print("%.*f", decimals, y));
    }
    // Half-way in the reach of the fast reader: odd multiples of half a unit between 2^23 and 2^24, and tenths of them.
    for (int i = 0; i < 20000; ++i) {
        const double x = 8388608.0 + static_cast<double>(random() % 8388608) + 0.5;
        check_number(print("%.*f", 1, x));
        check_number(print("%.*f", 8, x / 1024.0));
        check_number(print("%.*f", 14, x / 16777216.0));
        check_number(print("%.*f", 1, x + 0.1));
        check_number(print("%.*f", 1, x - 0.1));
    }
}

TEST_CASE("indices: eight characters at a time") {
    for (const uint32_t i : {1u, 9u, 10u, 99u, 100u, 12345u, 999999u, 1000000u, 9999999u}) {
        std::string text = std::to_string(i) + "/";
        text.append(64, '\0');
        uint32_t value = 0;
        const char* end = fast_index(text.data(), value);
        REQUIRE(end != nullptr);
        CHECK(*end == '/');
        CHECK(value == i);
    }
    for (std::string text : {"0/", "-1 ", "", "/", "12345678 ", "00000000 "}) {
        text.append(64, '\0');
        uint32_t value = 0;
        CHECK(fast_index(text.data(), value) == nullptr);
    }
}
