#include <cstdio>
#include <locale>

#include "01_obj/truth.h"
#include "checks.h"
#include "common/base/error.h"

namespace lightwalk {
namespace {

std::string show(float x) {
    char text[32];
    std::snprintf(text, sizeof text, "%.9g", static_cast<double>(x));
    return text;
}

std::string show(uint32_t index) { return index == none ? "none" : std::to_string(index); }

std::string show(const Corner& c) { return "(" + show(c.position) + ", " + show(c.uv) + ", " + show(c.normal) + ")"; }

// Streams whose locale writes 1.5 as 1,5, as in much of Europe.
struct CommaPoint : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\3"; }
};

struct CommaLocale {
    std::locale before = std::locale::global(std::locale(std::locale::classic(), new CommaPoint));
    ~CommaLocale() { std::locale::global(before); }
};

}  // namespace

Failures check_parse_vertex_line(glm::vec3 (*attempt)(std::string_view)) {
    Failures failures;
    const auto expect = [&](const std::string& line, const std::string& x, const std::string& y, const std::string& z) {
        const std::string call = "parse_vertex_line(\"" + line + "\")";
        try {
            const glm::vec3 got = attempt(line);
            const std::string text[3] = {x, y, z};
            for (int i = 0; i < 3; ++i)
                if (const float right = truth::nearest_float(text[i]); truth::ulps(got[i], right) != 0)
                    failures.push_back(call + " gave " + "xyz"[i] + " = " + show(got[i]) + ", expected " + show(right));
        } catch (const InputError& error) {
            failures.push_back(call + " said \"" + error.what() + "\", but the line is fine");
        }
    };
    const auto refuse = [&](const std::string& line, const std::string& why) {
        try {
            attempt(line);
            failures.push_back("parse_vertex_line(\"" + line + "\") found nothing wrong, expected InputError: " + why);
        } catch (const InputError&) {}
    };
    expect("v 1 2 3", "1", "2", "3");
    expect("v 0.254714 -0.437146 -0.082668", "0.254714", "-0.437146", "-0.082668");
    expect("v\t1.5   -2.25\t +3.125", "1.5", "-2.25", "3.125");
    expect("v .5 5. -0", ".5", "5", "-0");
    expect("v 1e3 2.5E-3 -1e+2", "1e3", "2.5e-3", "-1e2");
    expect("v 1 2 3 1.0", "1", "2", "3");
    expect("v 1 2 3 0.5 0.25 0.125", "1", "2", "3");
    expect("v 1 2 3 # three", "1", "2", "3");
    // Between two floats: exactly half-way goes to the even one, a trace more to the upper one.
    expect("v 16777217 16777219 16777217.0000001", "16777217", "16777219", "16777217.0000001");
    expect("v 0.100000001490116119384765625 3.4028234e38 1.1754943508e-38", "0.100000001490116119384765625",
           "3.4028234e38", "1.1754943508e-38");
    expect("v 1e-400 -1e-400 1e-45", "0", "-0", "1e-45");
    {
        const CommaLocale comma;
        expect("v 1.5 1234.5 0.25", "1.5", "1234.5", "0.25");
    }
    refuse("v 1 2", "a number is missing");
    refuse("v", "three numbers are missing");
    refuse("v 1 2 3 4 5", "3, 4, 6 or 7 numbers are right, 5 are not");
    refuse("v 1 2 3 4 5 6 7 8", "too many numbers");
    refuse("v 1 2 three", "'three' is not a number");
    refuse("v 1 2 3x", "'3x' is not a number");
    refuse("v 1,5 2 3", "a comma is not a decimal point");
    refuse("v nan 0 0", "nan is no position");
    refuse("v 0 -inf 0", "inf is no position");
    refuse("v 1e39 0 0", "1e39 does not fit a float");
    return failures;
}

Failures check_parse_face(std::vector<Corner> (*attempt)(std::string_view, const Counts&, const Counts&)) {
    Failures failures;
    const Counts so_far{8, 6, 4}, total{10, 6, 5};
    const auto expect = [&](const std::string& line, const std::vector<Corner>& right) {
        const std::string call = "parse_face(\"" + line + "\")";
        try {
            const std::vector<Corner> got = attempt(line, so_far, total);
            if (got.size() != right.size()) {
                failures.push_back(call + " gave " + std::to_string(got.size()) + " corners, expected " +
                                   std::to_string(right.size()));
                return;
            }
            for (size_t i = 0; i < right.size(); ++i)
                if (!(got[i] == right[i])) {
                    failures.push_back(call + " gave " + show(got[i]) + " as corner " + std::to_string(i) +
                                       ", expected " + show(right[i]) + " (position, uv, normal, counted from 0)");
                    return;
                }
        } catch (const InputError& error) {
            failures.push_back(call + " said \"" + error.what() + "\", but the line is fine");
        }
    };
    const auto refuse = [&](const std::string& line, const std::string& why) {
        try {
            attempt(line, so_far, total);
            failures.push_back("parse_face(\"" + line + "\") found nothing wrong, expected InputError: " + why);
        } catch (const InputError&) {}
    };
    expect("f 1 2 3", {{0, none, none}, {1, none, none}, {2, none, none}});
    expect("f 1/4 2/5 3/6", {{0, 3, none}, {1, 4, none}, {2, 5, none}});
    expect("f 1//3 2//4 3//1", {{0, none, 2}, {1, none, 3}, {2, none, 0}});
    expect("f 8/6/4 7/5/3 6/4/2", {{7, 5, 3}, {6, 4, 2}, {5, 3, 1}});
    expect("f 1 2 3 4 5", {{0, none, none}, {1, none, none}, {2, none, none}, {3, none, none}, {4, none, none}});
    expect("f  1/1/1\t2/2/2   3/3/3 # a comment", {{0, 0, 0}, {1, 1, 1}, {2, 2, 2}});
    expect("f -1 -2 -3", {{7, none, none}, {6, none, none}, {5, none, none}});
    expect("f -8/-6/-4 -7/-5/-3 1/1/1", {{0, 0, 0}, {1, 1, 1}, {0, 0, 0}});
    expect("f 10 9 8", {{9, none, none}, {8, none, none}, {7, none, none}});
    expect("f 1//5 2//5 3//5", {{0, none, 4}, {1, none, 4}, {2, none, 4}});
    refuse("f", "a face has three corners or more");
    refuse("f 1 2", "a face has three corners or more");
    refuse("f 0 1 2", "the first index is 1");
    refuse("f 1/0 2/1 3/1", "the first index is 1");
    refuse("f 1 2 11", "there are 10 positions");
    refuse("f 1/7 2/1 3/1", "there are 6 uvs");
    refuse("f 1//6 2//1 3//1", "there are 5 normals");
    refuse("f -9 1 2", "there are 8 positions so far");
    refuse("f 99999999999 1 2", "there are 10 positions");
    refuse("f 99999999999999999999999 1 2", "there are 10 positions");
    refuse("f 1 2 x", "x is no index");
    refuse("f 1 2 3.5", "an index is whole");
    refuse("f 1/ 2/ 3/", "nothing stands after the /");
    refuse("f 1/2/3/4 1 2", "a corner has three indices at most");
    return failures;
}

}  // namespace lightwalk
