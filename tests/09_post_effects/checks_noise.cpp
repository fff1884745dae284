// Checks of chapter 09's noises: grain, and the thresholds of a dither.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

#include "common/check/check.h"

using namespace lightwalk;

namespace {

// How much of one row of numbers is known from another: 0 for noise, 1 for the same.
double correlation(const std::vector<double>& a, const std::vector<double>& b) {
    double sum = 0, squares_a = 0, squares_b = 0;
    for (size_t i = 0; i < a.size(); ++i) {
        sum += a[i] * b[i];
        squares_a += a[i] * a[i];
        squares_b += b[i] * b[i];
    }
    return squares_a * squares_b > 0 ? sum / std::sqrt(squares_a * squares_b) : 1;
}

// The grain at `count` places, each (x, y, frame).
std::vector<double> grain(Check& check, size_t count, const std::function<Row(int)>& place) {
    Probe probe{.include = "09_post_effects/film_grain.glsl",
                .signature = "float film_grain(uvec2 pixel, uint frame)",
                .truth = [](std::span<const double>) { return Row{0}; },
                .bound = {.absolute = 1.0}};
    for (size_t i = 0; i < count; ++i) probe.inputs.push_back(place(int(i)));
    std::vector<double> numbers;
    for (const Row& row : check.probe(probe)) numbers.push_back(row[0]);
    return numbers;
}

// Evenly distributed: as many numbers in each sixteenth of -1 to 1. The normalised sum of squares has a mean of 15
// and a standard deviation of 5.5.
void expect_even(Check& check, const std::string& when, const std::vector<double>& numbers) {
    constexpr int parts = 16;
    double counts[parts] = {}, sum = 0;
    for (const double n : numbers) ++counts[std::clamp(int((n + 1) * parts / 2), 0, parts - 1)];
    const double expected = double(numbers.size()) / parts;
    for (const double count : counts) sum += (count - expected) * (count - expected) / expected;
    const auto most = std::max_element(std::begin(counts), std::end(counts));
    check.expect(sum < 60,
                 fmt::format("{}: of {} numbers {:.0f} are between {} and {}, expected about {:.0f}", when,
                             numbers.size(), *most, -1 + double(most - counts) * 2 / parts,
                             -1 + double(most - counts + 1) * 2 / parts, expected),
                 "evenly from -1 to 1: all numbers are as frequent");
}

// Grain that comes again: a long row, a long column, or one pixel's film, against itself, and against the line beside
// it or in the next frame, moved by every number of places up to 2,048. Of that many numbers a correlation has a
// standard error of 0.022: 0.15 is nearly seven of them.
void expect_no_repetition(Check& check, double frame) {
    constexpr int length = 4096, most = length / 2;
    struct Line {
        const char* name;
        const char* moves;
        Row from, step, beside;
        const char* beside_name;
    };
    const Row right{1, 0, 0}, down{0, 1, 0}, later{0, 0, 1}, start{700, 300, frame};
    const Line lines[] = {{"a row", "pixels to the right", start, right, down, "of the row below"},
                          {"a row", "pixels to the right", start, right, later, "of the next frame"},
                          {"a column", "pixels below", start, down, later, "of the next frame"},
                          {"a column", "pixels below", start, down, right, "of the column to the right"},
                          {"a pixel's film", "frames later", start, later, right, "of the pixel to the right"},
                          {"a pixel's film", "frames later", start, later, down, "of the pixel below"}};
    for (const Line& line : lines) {
        const auto numbers = [&](double besides) {
            return grain(check, length, [&](int i) {
                Row place(3);
                for (size_t k = 0; k < 3; ++k) place[k] = line.from[k] + line.step[k] * i + line.beside[k] * besides;
                return place;
            });
        };
        const std::vector<double> own = numbers(0), next = numbers(1);
        if (own.empty() || next.empty() || check.failed) return;
        for (const bool beside : {false, true}) {
            std::vector<std::pair<int, double>> alike;  // lag, correlation of numbers with a mean square of 1/3
            for (int lag = beside ? -most : 1; lag <= most; ++lag) {
                const size_t back = lag < 0 ? size_t(-lag) : 0, on = lag < 0 ? 0 : size_t(lag);
                double sum = 0;
                for (size_t i = 0; i < most; ++i) sum += own[i + back] * (beside ? next : own)[i + on];
                alike.emplace_back(lag, std::fabs(sum * 3 / most));
            }
            double worst = 0;
            for (const auto& [lag, by] : alike) worst = std::max(worst, by);
            const auto found =
                std::find_if(alike.begin(), alike.end(), [&](auto one) { return one.second >= 0.9 * worst; });
            check.expect(
                worst < 0.15,
                fmt::format("frame {:.0f}: {} has a correlation of {:.2f} with itself {} {}{}{}, expected 0", frame,
                            line.name, found->second, found->first, line.moves, beside ? ", " : "",
                            beside ? line.beside_name : ""),
                "grain that comes again is a pattern, and the eye finds it: every bit of x, y and frame must go "
                "through the mixing");
            if (worst >= 0.15) return;
        }
    }
}

}  // namespace

CHECK_EXERCISE("09.film_grain", "A hash of three integers: multiply, exclusive or with the number shifted, repeat.") {
    constexpr int side = 48;
    constexpr size_t all = side * side;
    // 2,304 numbers: a mean of 0 has a standard error of 0.012, a correlation one of 0.021. Five of them are a proof.
    for (const double frame : {0.0, 5.0, 24e6, 4.2e9}) {
        const std::string when = fmt::format("frame {:.0f}", frame);
        const auto look = [&](double x0, double y0, double at) {
            return grain(check, all, [&](int i) { return Row{x0 + i % side, y0 + int(i / side), at}; });
        };
        const std::vector<double> here = look(700, 300, frame);
        if (here.empty()) return;
        double mean = 0, square = 0;
        for (const double n : here) {
            mean += n / all;
            square += n * n / all;
        }
        check.expect(std::fabs(mean) < 0.06,
                     fmt::format("{}: the mean over 48 by 48 pixels is {:.3f}, expected 0", when, mean),
                     "from -1 to 1: twice the number from 0 to 1, minus 1");
        check.expect(std::fabs(square - 1.0 / 3.0) < 0.035,
                     fmt::format("{}: the mean square is {:.3f}, expected 0.333", when, square),
                     "evenly from -1 to 1: all numbers are as frequent");
        const size_t different = std::set<double>(here.begin(), here.end()).size();
        check.expect(different > all * 97 / 100,
                     fmt::format("{}: of {} numbers only {} are different", when, all, different),
                     "a large time leaves no digits to a sum or a sine: mix integer bits");
        expect_even(check, when, here);
        const std::tuple<double, double, double, const char*> others[] = {
            {701, 300, frame, "the pixel to the right"},       {700, 301, frame, "the pixel below"},
            {701, 301, frame, "the pixel below on the right"}, {700, 300, frame + 1, "the next frame"},
            {300, 700, frame, "the pixel mirrored"},           {701, 299, frame, "the pixel above on the right"}};
        for (const auto& [x, y, at, name] : others) {
            std::vector<double> other = look(x, y, at);
            if (x < 600)  // rows become columns
                for (size_t row = 0; row < side; ++row)
                    for (size_t i = 0; i < row; ++i) std::swap(other[row * side + i], other[i * side + row]);
            const double alike = correlation(here, other);
            check.expect(std::fabs(alike) < 0.11,
                         fmt::format("{}: {} has a correlation of {:.2f}, expected 0", when, name, alike),
                         "each of x, y and frame must go through the mixing");
        }
        for (const bool rows : {true, false}) {
            double worst = 0;
            for (int line = 0; line < side; ++line) {
                double sum = 0;
                for (int i = 0; i < side; ++i) sum += here[size_t(rows ? line * side + i : i * side + line)] / side;
                worst = std::max(worst, std::fabs(sum));
            }
            check.expect(worst < 0.4, fmt::format("{}: a {} has a mean of {:.2f}, expected 0", when,
                                                  rows ? "row" : "column", worst));
        }
        if (check.failed > 0) return;
    }
    for (const double frame : {0.0, 24e6}) {
        expect_no_repetition(check, frame);
        if (check.failed > 0) return;
    }
}

CHECK_EXERCISE("09.bayer_dither", "The lowest bits of x and y weigh most, because neighbours must differ most.") {
    for (int bits = 1; bits <= 4; ++bits) {
        const int side = 1 << bits, all = side * side;
        Probe probe{.include = "09_post_effects/bayer_dither.glsl",
                    .signature = "float bayer(uvec2 pixel, int bits)",
                    .truth = [](std::span<const double>) { return Row{0.5}; },
                    .bound = {.absolute = 0.5}};
        // Squares of a picture: far from its corner first, then at it, beside that, below, and farther down.
        const glm::ivec2 squares[] = {{64, 32}, {0, 0}, {1, 0}, {0, 1}, {3, 5}};
        for (const glm::ivec2 square : squares)
            for (int i = 0; i < all; ++i)
                probe.inputs.push_back(
                    {double(i % side + square.x * side), double(int(i / side) + square.y * side), double(bits)});
        const Table results = check.probe(probe);
        if (results.empty()) return;
        std::vector<int> ranks(size_t(all), -1);
        std::vector<char> taken(size_t(all), 0);
        for (int i = 0; i < all; ++i) {
            const double rank = results[size_t(i)][0] * all - 0.5;
            const auto whole = std::lround(rank);
            const bool right =
                std::fabs(rank - double(whole)) < 1e-3 && whole >= 0 && whole < all && !taken[size_t(whole)];
            check.expect(
                right,
                fmt::format("bayer(pixel = ({}, {}), bits = {}) gave {:.6f}, expected (0.5 + i) / {} with another i "
                            "for each pixel of the square",
                            i % side, i / side, bits, results[size_t(i)][0], all),
                "each threshold once: then their mean is a half, and no shade is lost");
            if (!right) return;
            taken[size_t(whole)] = 1;
            ranks[size_t(i)] = int(whole);
        }
        for (size_t i = size_t(all); i < results.size(); ++i) {
            const double here = results[i][0], first = results[i % size_t(all)][0];
            check.expect(
                std::fabs(here - first) < 1e-3 / all,
                fmt::format("bayer(pixel = ({}, {}), bits = {}) gave {:.6f}, and {:.6f} at ({}, {}): the square of "
                            "{} by {} pixels repeats",
                            probe.inputs[i][0], probe.inputs[i][1], bits, here, first, probe.inputs[i % size_t(all)][0],
                            probe.inputs[i % size_t(all)][1], side, side),
                "of x and y the lowest `bits` bits count, and no others");
            if (check.failed) return;
        }
        // Bayer's own matrix, mirrored or turned: the one that has most ranks alike says which pixel is wrong.
        const auto bayer_rank = [&](int x, int y) {
            int rank = 0;
            for (int bit = 0; bit < bits; ++bit)
                rank = 4 * rank + 2 * ((x >> bit & 1) ^ (y >> bit & 1)) + (y >> bit & 1);
            return rank;
        };
        int most_alike = -1, wrong = -1, expected = 0;
        for (int form = 0; form < 8; ++form) {
            int alike = 0, first = -1, rank_there = 0;
            for (int i = 0; i < all; ++i) {
                int x = i % side, y = i / side;
                if (form & 1) x = side - 1 - x;
                if (form & 2) y = side - 1 - y;
                if (form & 4) std::swap(x, y);
                const int rank = bayer_rank(x, y);
                if (rank == ranks[size_t(i)])
                    ++alike;
                else if (first < 0) {
                    first = i;
                    rank_there = rank;
                }
            }
            if (alike > most_alike) {
                most_alike = alike;
                wrong = first;
                expected = rank_there;
            }
        }
        check.expect(
            most_alike == all,
            fmt::format("bayer(pixel = ({}, {}), bits = {}) has the rank {}, and Bayer's matrix {}: turned and "
                        "mirrored as is nearest, {} of {} ranks are alike",
                        wrong % side, wrong / side, bits, wrong < 0 ? 0 : ranks[size_t(wrong)], expected, most_alike,
                        all),
            "which bits of x and y come first? Pixels beside each other differ in the lowest");
        if (check.failed) return;
    }
}
