// Checks of chapter 13's functions: values against double precision, then properties.
#include <fmt/core.h>

#include <cmath>

#include "13_mlaa/exercises.h"
#include "13_mlaa/truth.h"
#include "common/check/check.h"

using namespace lightwalk;

namespace {

const double infinity = std::numeric_limits<double>::infinity(), not_a_number = std::nan("");

// As 13_mlaa/edge_source.glsl has it for checks.
bool known_edge(int x, int y, uint32_t which) {
    uint32_t n = (uint32_t(x + 64) * 73856093u) ^ (uint32_t(y + 64) * 19349663u) ^ (which * 83492791u);
    n = (n ^ n >> 13) * 0x5bd1e995u;
    return ((n ^ n >> 15) & 256u) != 0u;
}

struct End {
    bool near, far, beyond;
};

// The crossing edges at an end of a line; `x`, `y`: the near pixel, and the one beyond it.
End end_at(int x, int y, int beyond_x, int beyond_y, bool horizontal) {
    return {known_edge(x, y, horizontal), known_edge(x + !horizontal, y + horizontal, horizontal),
            known_edge(beyond_x, beyond_y, !horizontal)};
}

int side_of(const End& end, const End& other) {
    const auto alone = [](const End& e) { return e.beyond ? 0 : int(e.far) - int(e.near); };
    if (end.beyond && end.near && end.far) return -alone(other);
    return alone(end);
}

std::pair<End, End> ends_of(std::span<const double> in) {
    const bool horizontal = in[4] != 0;
    const int dx = horizontal, dy = !horizontal;
    const int fx = int(in[0]), fy = int(in[1]), lx = int(in[2]), ly = int(in[3]);
    return {end_at(fx - dx, fy - dy, fx - dx, fy - dy, horizontal), end_at(lx, ly, lx + dx, ly + dy, horizontal)};
}

}  // namespace

CHECK_EXERCISE("13.lab_distance", "Apply f() to each component first; then compute L, a and b from the three.") {
    Probe probe{.include = "13_mlaa/lab_distance.glsl",
                .signature = "vec3 to_lab(vec3 light)",
                .inputs = {{0, 0, 0},
                           {1, 1, 1},
                           {1, 0, 0},
                           {0, 1, 0},
                           {0, 0, 1},
                           {0.18, 0.18, 0.18},
                           {0.001, 0.001, 0.001},
                           {0.0088, 0.0088, 0.0088},
                           {0.0089, 0.0089, 0.0089},
                           {0, 0, 0.001},
                           {16, 4, 1}},
                .truth =
                    [](std::span<const double> in) {
                        const glm::dvec3 lab = truth::to_lab(vector3(in));
                        return Row{lab.x, lab.y, lab.z};
                    },
                .bound = {.absolute = 0.03, .relative = 1e-4},  // 500 times the error of pow()
                .hint = [](auto in, auto) -> std::string {
                    if (std::max({in[0], in[1], in[2]}) < 0.01)
                        return "Below (6/29)^3 f is a straight line, and f(0) = 4/29.";
                    return "";
                }};
    Random random;
    for (int i = 0; i < 600; ++i)
        probe.inputs.push_back({random.uniform(0, 1), random.uniform(0, 1), random.uniform(0, 1)});
    for (int i = 0; i < 200; ++i)
        probe.inputs.push_back(
            {random.logarithmic(1e-5, 20), random.logarithmic(1e-5, 20), random.logarithmic(1e-5, 20)});
    check.probe(probe);

    Probe distance{
        .include = "13_mlaa/lab_distance.glsl",
        .signature = "float lab_distance(vec3 lab, vec3 other)",
        .inputs = {{0, 0, 0, 0, 0, 0}, {100, 0, 0, 0, 0, 0}, {50, 20, -30, 50, -20, 30}, {50, 3, 4, 50, 0, 0}},
        .truth = [](std::span<const double> in) { return Row{glm::distance(vector3(in), vector3(in.subspan(3)))}; },
        .bound = {.absolute = 1e-4, .relative = 1e-5}};
    for (int i = 0; i < 300; ++i) {
        Row row;
        for (int c = 0; c < 6; ++c) row.push_back(random.uniform(c % 3 ? -100 : 0, 100));
        distance.inputs.push_back(row);
    }
    check.probe(distance);
}

CHECK_EXERCISE("13.propagate_distance", "Begin with known(0); read each further number at the current sum.") {
    std::vector<std::vector<uint32_t>> lines{{1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 0},
                                             {4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 3, 2, 1, 0},
                                             {3, 2, 1, 0, 5, 4, 3, 2, 1, 0, 4, 3, 2, 1, 0, 0},
                                             {2, 2, 2, 2, 2, 2, 1, 0, 2, 2, 2, 2, 2, 2, 1, 0},
                                             {0, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 0},
                                             {200, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 0},
                                             std::vector<uint32_t>(16, 254),
                                             std::vector<uint32_t>(16, 100)};  // sums that no byte holds
    // Lines that end somewhere, of which each place knows no more than a number of steps.
    Random random(2);
    for (int i = 0; i < 2; ++i) {
        const auto most = static_cast<uint32_t>(random.uniform(3, 9));
        std::vector<uint32_t> line(16, 0);
        for (size_t at = 15; at-- > 0;)
            if (random.uniform(0, 1) < 0.85) line[at] = std::min(line[at + 1] + 1, most);
        lines.push_back(line);
    }
    for (const std::vector<uint32_t>& line : lines)
        for (const int reads : {2, 3, 4}) {
            std::string words;
            for (const uint32_t word : line) words += fmt::format("{}{}u", words.empty() ? "" : ", ", word);
            Probe probe{.include = "13_mlaa/propagate_distance.glsl",
                        .before = "#include \"../tests/13_mlaa/known_line.glsl\"\n",
                        .signature = "uint propagate_distance(int reads, uint reach)",
                        .inputs = {},
                        .truth =
                            [&](std::span<const double> in) {
                                uint32_t sum = line[0];
                                const auto known = [&](size_t steps) { return line[std::min(steps, line.size() - 1)]; };
                                for (int i = 1; i < int(in[0]) && known(sum) > 0; ++i) sum += known(sum);
                                return Row{std::min(double(sum), in[1])};
                            },
                        .macros = {{"KNOWN_DISTANCES", words}, {"MOST_READS", fmt::format("{}u", reads)}},
                        .hint = [&](auto in, auto got) -> std::string {
                            const std::string told =
                                fmt::format("known(0), known(1) ... are {}, {}, {}, {}, {}, {} ... here; ", line[0],
                                            line[1], line[2], line[3], line[4], line[5]);
                            if (got[0] > in[1]) return told + "the result is above the reach";
                            if (got[0] >= 99)
                                return told + fmt::format("known() may be asked {} times, and then no more", in[0]);
                            return told + "the next number is read where the sum so far ends";
                        }};
            for (const int reach : {254, 100, 15, 9, 6, 3, 1}) probe.inputs.push_back({double(reads), double(reach)});
            check.probe(probe);
            if (check.failed) return;
        }
}

CHECK_EXERCISE("13.line_ends",
               "At each end test three edges: the continuation, and the crossing edges on the near and the far side.") {
    Probe probe{.include = "13_mlaa/line_ends.glsl",
                .before = "#include \"../tests/13_mlaa/known_edges.glsl\"\n",
                .signature = "ivec2 line_ends(ivec2 first, ivec2 last, bool horizontal)",
                .inputs = {},
                .truth =
                    [](std::span<const double> in) {
                        const auto [back, ahead] = ends_of(in);
                        return Row{double(side_of(back, ahead)), double(side_of(ahead, back))};
                    },
                .hint = [](auto in, auto) -> std::string {
                    const auto [back, ahead] = ends_of(in);
                    const auto words = [](const End& e) {
                        return fmt::format("{} on the near side, {} on the far side, the next edge is {}",
                                           e.near ? "an edge" : "none", e.far ? "an edge" : "none",
                                           e.beyond ? "there" : "not there");
                    };
                    return fmt::format("before `first`: {}; behind `last`: {}", words(back), words(ahead));
                }};
    Random random;
    for (int i = 0; i < 1500; ++i) {
        const int x = int(random.uniform(-20, 20)), y = int(random.uniform(-20, 20));
        const int more = i % 5 == 0 ? 0 : int(random.uniform(0, 12)), horizontal = i % 2;
        probe.inputs.push_back({double(x), double(y), double(x + (horizontal ? more : 0)),
                                double(y + (horizontal ? 0 : more)), double(horizontal)});
    }
    check.probe(probe);
}

CHECK_EXERCISE("13.area", "A trapezium as wide as the pixel, or a triangle that ends in the middle of the line.") {
    std::vector<int> lengths{1, 2, 3, 4, 5, 7, 8, 31, 64, 255, 256, 509};
    Random random(2);
    for (int i = 0; i < 8; ++i) lengths.push_back(static_cast<int>(random.uniform(9, 509)));
    for (const int length : lengths)
        for (int position = 0; position < length; ++position) {
            const std::string what = fmt::format("area({}, {})", position, length);
            check.call(what, [&]() -> std::string {
                const double got = double(area(position, length)), right = truth::area(position, length);
                if (std::abs(got - right) <= 1e-6) return "";
                std::string why;
                if (length == 1)
                    why = ": a line of one pixel is a step of another line";
                else if (2 * position + 1 == length)
                    why = ": the outline ends in the middle of this pixel, and leaves a triangle";
                else if (2 * position >= length)
                    why = ": this pixel lies behind the middle";
                return fmt::format("{} gave {:.6f}, expected {:.6f}{}", what, got, right, why);
            });
            if (check.failed) return;
        }
}

CHECK_EXERCISE("13.blend", "Light of weight 0 must be left out, not multiplied by 0.") {
    const double n = not_a_number, i = infinity;
    Probe probe{.include = "13_mlaa/blend.glsl",
                .signature = "vec3 blend(vec3 own, vec3 left, vec3 right, vec3 above, vec3 below, vec4 weights)",
                .inputs = {{1, 2, 3, 0, 0, 0, 9, 9, 9, 8, 8, 8, 7, 7, 7, 0, 0, 0, 0},
                           {1, 2, 3, 4, 5, 6, 9, 9, 9, 8, 8, 8, 7, 7, 7, 0.5, 0, 0, 0},
                           {1, 2, 3, 4, 5, 6, 9, 9, 9, 8, 8, 8, 7, 7, 7, 0, 0.25, 0, 0.25},
                           {1, 2, 3, 4, 5, 6, 9, 9, 9, 8, 8, 8, 7, 7, 7, 0.5, 0.5, 0.5, 0.5},
                           {1, 2, 3, 4, 5, 6, 9, 9, 9, 8, 8, 8, 7, 7, 7, 0, 0, 0.75, 0.75},
                           {0, 0, 0, n, n, n, i, i, i, 1, 1, 1, n, i, 0, 0, 0, 0.5, 0},
                           {1, 1, 1, n, n, n, n, n, n, n, n, n, n, n, n, 0, 0, 0, 0},
                           {1, 1, 1, 2, 2, 2, i, n, i, n, i, n, 3, 3, 3, 0.125, 0, 0, 0.25},
                           {n, i, n, 2, 2, 2, n, n, n, 4, 4, 4, i, i, i, 0.5, 0, 0.5, 0}},
                .truth =
                    [](std::span<const double> in) {
                        const double sum = in[15] + in[16] + in[17] + in[18];
                        glm::dvec3 result = sum < 1 ? (1 - sum) * vector3(in) : glm::dvec3(0);
                        for (size_t k = 0; k < 4; ++k)
                            if (in[15 + k] > 0)
                                result += in[15 + k] / std::max(sum, 1.0) * vector3(in.subspan(3 + 3 * k));
                        return Row{result.x, result.y, result.z};
                    },
                .bound = {.absolute = 2e-6, .relative = 1e-5},
                .hint = [](auto in, auto out) -> std::string {
                    if (in[15] + in[16] + in[17] + in[18] > 1)
                        return "The weights add up to more than 1: divide them by their sum.";
                    for (const double value : out)
                        if (!std::isfinite(value)) return "0 times NaN is NaN, and so is 0 times infinity.";
                    return "";
                }};
    Random random;
    for (int k = 0; k < 500; ++k) {
        Row row;
        for (int c = 0; c < 15; ++c) row.push_back(random.uniform(0, 2));
        for (int c = 0; c < 4; ++c) row.push_back((k >> c) % 3 ? random.uniform(0, k % 2 ? 0.25 : 0.6) : 0.0);
        probe.inputs.push_back(row);
    }
    check.probe(probe);
}
