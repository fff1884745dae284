#include <cstdio>

#include "01_obj/exercises.h"
#include "01_obj/truth.h"
#include "common/base/error.h"
#include "common/check/check.h"
#include "common/check/comma_locale.h"

namespace lightwalk {
namespace {

std::string show(float x) {
    char text[32];
    std::snprintf(text, sizeof text, "%.9g", static_cast<double>(x));
    return text;
}

std::string show(uint32_t index) { return index == none ? "none" : std::to_string(index); }

std::string show(const Corner& c) {
    return "position " + show(c.position) + ", uv " + show(c.uv) + ", normal " + show(c.normal);
}

}  // namespace

CHECK_EXERCISE("01.parse_vertex_line",
               "std::from_chars rounds correctly and ignores the locale; check how many numbers there are") {
    const auto expect = [&](const std::string& line, const std::string& x, const std::string& y, const std::string& z,
                            const std::string& why = "") {
        const std::string call = "parse_vertex_line(\"" + line + "\")";
        check.call(
            call,
            [&]() -> std::string {
                try {
                    const glm::vec3 got = parse_vertex_line(line);
                    const std::string text[3] = {x, y, z};
                    for (int i = 0; i < 3; ++i)
                        if (const float right = truth::nearest_float(text[i]); truth::ulps(got[i], right) != 0)
                            return call + " gave " + "xyz"[i] + " = " + show(got[i]) + ", expected " + show(right);
                } catch (const InputError& error) {
                    return call + " said \"" + error.what() + "\", but the line is fine";
                }
                return "";
            },
            why);
    };
    const auto refuse = [&](const std::string& line, const std::string& why) {
        const std::string call = "parse_vertex_line(\"" + line + "\")";
        check.call(call, [&]() -> std::string {
            try {
                parse_vertex_line(line);
                return call + " found nothing wrong, expected InputError: " + why;
            } catch (const InputError&) { return ""; }
        });
    };
    expect("v 1 2 3", "1", "2", "3");
    expect("v 0.254714 -0.437146 -0.082668", "0.254714", "-0.437146", "-0.082668");
    expect("v\t1.5   -2.25\t +3.125", "1.5", "-2.25", "3.125");
    expect("v .5 5. -0", ".5", "5", "-0");
    expect("v 1e3 2.5E-3 -1e+2", "1e3", "2.5e-3", "-1e2");
    expect("v 1 2 3 1.0", "1", "2", "3");
    expect("v 1 2 3 0.5 0.25 0.125", "1", "2", "3");
    expect("v 1 2 3 # three", "1", "2", "3", "from a word that begins with # to the line's end it is a comment");
    expect("v 1 2 3 #4 5", "1", "2", "3", "from a word that begins with # to the line's end it is a comment");
    // Between two floats: exactly half-way goes to the even one, a trace more to the upper one.
    expect("v 16777217 16777219 16777217.0000001", "16777217", "16777219", "16777217.0000001");
    expect("v 0.100000001490116119384765625 3.4028234e38 1.1754943508e-38", "0.100000001490116119384765625",
           "3.4028234e38", "1.1754943508e-38");
    expect("v 1e-400 -1e-400 1e-45", "0", "-0", "1e-45");
    // Further than a double can tell from half-way: a double in between takes it for half-way and rounds a second time.
    const std::string twice = "a double in between rounds a second time: read a float";
    expect("v 16777217.0000000000000001 0 0", "16777217.0000000000000001", "0", "0", twice);
    expect("v 0 1.00000005960464477539062500001 0", "0", "1.00000005960464477539062500001", "0", twice);
    {
        const CommaLocale comma;
        expect(
            "v 1.5 1234.5 0.25", "1.5", "1234.5", "0.25",
            "here the computer's own language writes 1,5: strtof, stof and streams look at that, std::from_chars does "
            "not");
    }
    refuse("v 1 2", "a number is missing");
    refuse("v", "three numbers are missing");
    refuse("v 1 2 3 4 5", "3, 4, 6 or 7 numbers are right, 5 are not");
    refuse("v 1 2 3 4 5 6 7 8", "too many numbers");
    refuse("v 1 2 three", "'three' is not a number");
    refuse("v 1 2 3x", "'3x' is not a number");
    refuse("v 1,5 2 3", "a comma is not a decimal point");
    refuse("v 0x10 2 3", "a number is decimal, 0x10 is not");
    refuse("v 1 2 3 w", "what follows the position must be numbers too");
    refuse("v nan 0 0", "nan is no position");
    refuse("v 0 -inf 0", "inf is no position");
    refuse("v 1e39 0 0", "1e39 does not fit a float");
    refuse("v 0 -1e400 0", "-1e400 fits neither a float nor a double, and is not small");
    refuse("v +-5 0 0", "a number has one sign");
}

CHECK_EXERCISE("01.parse_face", "a negative index counts back from the last one read so far: -1 is that one") {
    const Counts so_far{8, 6, 4}, total{10, 6, 5};
    const auto expect = [&](const std::string& line, const std::vector<Corner>& right, const std::string& hint = "") {
        const std::string call = "parse_face(\"" + line + "\")";
        check.call(
            call,
            [&]() -> std::string {
                try {
                    const std::vector<Corner> got = parse_face(line, so_far, total);
                    if (got.size() != right.size())
                        return call + " gave " + std::to_string(got.size()) + " corners, expected " +
                               std::to_string(right.size());
                    for (size_t i = 0; i < right.size(); ++i)
                        if (!(got[i] == right[i]))
                            return call + " gave the corner number " + std::to_string(i + 1) + " " + show(got[i]) +
                                   ", expected " + show(right[i]);
                } catch (const InputError& error) {
                    return call + " said \"" + error.what() + "\", but the line is fine";
                }
                return "";
            },
            hint);
    };
    const auto refuse = [&](const std::string& line, const std::string& why, const std::string& hint = "") {
        const std::string call = "parse_face(\"" + line + "\")";
        check.call(
            call,
            [&]() -> std::string {
                try {
                    parse_face(line, so_far, total);
                    return call + " found nothing wrong, expected InputError: " + why;
                } catch (const InputError&) { return ""; }
            },
            hint);
    };
    const std::string counted = "a Corner counts from 0, the file from 1; what a corner leaves out stays `none`";
    const std::string back = "a negative index counts back from the last one read so far: -1 is that one";
    const std::string wraps =
        "as a 32-bit number it would wrap around to a small one: read 64 bits and look at the error";
    expect("f 1 2 3", {{0, none, none}, {1, none, none}, {2, none, none}}, counted);
    expect("f 1/4 2/5 3/6", {{0, 3, none}, {1, 4, none}, {2, 5, none}}, counted);
    expect("f 1//3 2//4 3//1", {{0, none, 2}, {1, none, 3}, {2, none, 0}}, counted);
    expect("f 1// 2// 3/4/", {{0, none, none}, {1, none, none}, {2, 3, none}},
           "a corner may end with a slash, and what would follow it is left out");
    expect("f 8/6/4 7/5/3 6/4/2", {{7, 5, 3}, {6, 4, 2}, {5, 3, 1}}, counted);
    expect("f 1 2 3 4 5", {{0, none, none}, {1, none, none}, {2, none, none}, {3, none, none}, {4, none, none}},
           counted);
    expect("f  1/1/1\t2/2/2   3/3/3 # a comment", {{0, 0, 0}, {1, 1, 1}, {2, 2, 2}},
           "words are parted by any number of spaces and tabs, and one that begins with # begins a comment");
    expect("f -1 -2 -3", {{7, none, none}, {6, none, none}, {5, none, none}}, back);
    expect("f -8/-6/-4 -7/-5/-3 1/1/1", {{0, 0, 0}, {1, 1, 1}, {0, 0, 0}}, back);
    expect("f 10 9 8", {{9, none, none}, {8, none, none}, {7, none, none}}, counted);
    expect("f 1//5 2//5 3//5", {{0, none, 4}, {1, none, 4}, {2, none, 4}}, counted);
    refuse("f", "a face has three corners or more");
    refuse("f 1 2", "a face has three corners or more");
    refuse("f 0 1 2", "the first index is 1");
    refuse("f 1/0 2/1 3/1", "the first index is 1");
    refuse("f 1 2 11", "there are 10 positions");
    refuse("f 1/7 2/1 3/1", "there are 6 uvs");
    refuse("f 1//6 2//1 3//1", "there are 5 normals");
    refuse("f -9 1 2", "there are 8 positions so far");
    refuse("f 4294967297 1 2", "there are 10 positions", wraps);
    refuse("f -4294967297 1 2", "there are 8 positions so far", wraps);
    refuse("f 1/4294967297 2/1 3/1", "there are 6 uvs", wraps);
    refuse("f 99999999999 1 2", "there are 10 positions", wraps);
    refuse("f 18446744073709551617 1 2", "there are 10 positions", wraps);
    refuse("f 99999999999999999999999 1 2", "there are 10 positions", wraps);
    refuse("f 1 2 x", "x is no index");
    refuse("f 1 2 3.5", "an index is whole");
    refuse("f 1/2/3/4 1 2", "a corner has three indices at most");
}

}  // namespace lightwalk
