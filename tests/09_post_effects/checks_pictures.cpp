// Checks of chapter 09's functions that look at more than a pixel: kernels, a whole workgroup.
#include <fmt/core.h>

#include <cmath>
#include <set>

#include "09_post_effects/truth.h"
#include "common/check/barriers.h"
#include "common/check/check.h"
#include "common/gpu/frame.h"

using namespace lightwalk;

CHECK_EXERCISE("09.radial_blur",
               "There are taps - 1 intervals between the reads; the first read is the pixel itself.") {
    Random random;
    Probe probe{.include = "09_post_effects/radial_blur.glsl",
                .before = "#include \"../tests/09_post_effects/known_picture.glsl\"\n",
                .signature = "vec3 radial_blur(vec2 uv, vec2 centre, float strength, int taps)",
                .inputs = {{0.2, 0.3, 0.5, 0.5, 0.5, 1},
                           {0.2, 0.3, 0.5, 0.5, 0, 4},
                           {0.5, 0.5, 0.5, 0.5, 1, 4},
                           {0, 0, 1, 1, 1, 2},
                           {0, 0, 1, 1, 1, 64},
                           {0.9, 0.1, 0.1, 0.6, 0.25, 4}},
                .truth =
                    [](std::span<const double> in) {
                        const int taps = int(in[5]);
                        glm::dvec3 sum(0);
                        for (int i = 0; i < taps; ++i) {
                            const glm::dvec2 uv(in[0], in[1]), centre(in[2], in[3]);
                            const glm::dvec2 at = uv + (taps > 1 ? in[4] * i / (taps - 1) : 0) * (centre - uv);
                            sum += glm::dvec3(at, at.x * at.x + at.y) / double(taps);
                        }
                        return Row{sum.x, sum.y, sum.z};
                    },
                .bound = {.absolute = 5e-6, .relative = 1e-5},
                .hint = [](auto in, auto) -> std::string {
                    if (in[5] == 1) return "With one tap there is no interval to divide by.";
                    return "There are taps - 1 intervals, and the last tap lies at the full strength; take the mean of "
                           "all taps.";
                }};
    for (int i = 0; i < 200; ++i)
        probe.inputs.push_back({random.uniform(0, 1), random.uniform(0, 1), random.uniform(0, 1), random.uniform(0, 1),
                                random.uniform(0, 1), double(1 + i % 20)});
    check.probe(probe);
}

CHECK_EXERCISE("09.sharpen", "Two loops of three; clamp each neighbour into the picture before reading it.") {
    Random random;
    const Row identity{0, 0, 0, 0, 1, 0, 0, 0, 0}, emboss{-2, -1, 0, -1, 1, 1, 0, 1, 2},
        edges{-1, -1, -1, -1, 8, -1, -1, -1, -1};
    Probe probe{.include = "09_post_effects/sharpen.glsl",
                .before = "#include \"../tests/09_post_effects/known_picture.glsl\"\n",
                .signature = "vec3 sharpen(ivec2 pixel, mat3 kernel)",
                .truth =
                    [](std::span<const double> in) {
                        glm::dvec3 sum(0);
                        for (int row = 0; row < 3; ++row)
                            for (int column = 0; column < 3; ++column) {
                                const int x = std::clamp(int(in[0]) + column - 1, 0, 4),
                                          y = std::clamp(int(in[1]) + row - 1, 0, 3);
                                sum += in[size_t(2 + 3 * row + column)] *
                                       glm::dvec3(1 + x + 10 * y, x * x, x == 2 && y == 1 ? 1 : 0);
                            }
                        sum = glm::max(sum, glm::dvec3(0));
                        return Row{sum.x, sum.y, sum.z};
                    },
                .bound = {.absolute = 2e-4, .relative = 2e-5},
                .hint = [](auto in, auto out) -> std::string {
                    for (const double c : out) {
                        if (c < 0) return "Light is never below 0.";
                        if (std::fabs(c) > 1e4) return "A pixel outside of the picture was read: clamp its position.";
                    }
                    const bool border = in[0] == 0 || in[1] == 0 || in[0] == 4 || in[1] == 3;
                    return border ? "At the border, the nearest pixel inside replaces each missing neighbour."
                                  : "In kernel[row][column] the row is y, counted from the top.";
                }};
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 5; ++x)
            for (const Row& kernel : {identity, emboss, edges}) {
                Row row{double(x), double(y)};
                row.insert(row.end(), kernel.begin(), kernel.end());
                probe.inputs.push_back(row);
            }
    for (int i = 0; i < 100; ++i) {
        Row row{double(i % 5), double(i / 5 % 4)};
        for (int k = 0; k < 9; ++k) row.push_back(random.uniform(-1, 2));
        probe.inputs.push_back(row);
    }
    check.probe(probe);
}

namespace {

// Four workgroups with threads in different orders, and with garbage in shared memory.
constexpr const char* harness = R"(
layout(local_size_x = 256) in;
#include "../tests/09_post_effects/known_bins.glsl"
#include "09_post_effects/histogram_bin.glsl"
layout(scalar) readonly buffer GivenBuffer { uint given[]; };
layout(scalar) writeonly buffer PassedBuffer { uint passed[]; };
void main() {
    own_bins[gl_LocalInvocationIndex] = 1000u + gl_LocalInvocationIndex;
    check_barrier();
    uint word = given[gl_GlobalInvocationID.x];
    count_together(word & 255u, word < 256u);
    passed[gl_GlobalInvocationID.x] = check_barriers_passed;
}
)";

void count(Check& check, const std::string& what, const std::vector<uint32_t>& given, uint32_t most_groups) {
    Gpu& gpu = check_device();
    const Pipeline pipeline = compute({.shader = "check of histogram_bin", .source = traced_barriers() + harness});
    const Buffer words = gpu.upload("given", given), bins = gpu.upload("bins", std::vector<uint32_t>(512, 0));
    const Buffer passed(gpu.device, {.name = "passed", .bytes = 4 * given.size()});
    Frame frame(gpu);
    frame.begin({4, 4}, 0);
    frame.compute("count", {.reads = {words, bins}, .writes = {bins, passed}}, [&](Compute& pass) {
        pass.use(pipeline).set("given", words).set("picture_bins", bins).set("passed", passed);
        pass.dispatch({most_groups, 1, 1});
    });
    frame.end();
    const auto bytes = gpu.read_back(bins);
    std::vector<uint32_t> found(512), expected(512, 0);
    std::memcpy(found.data(), bytes.data(), 2048);
    for (uint32_t group = 0; group < most_groups; ++group) {
        std::set<uint32_t> seen;
        for (uint32_t i = 0; i < 256; ++i)
            if (const uint32_t word = given[256 * group + i]; word < 256) {
                ++expected[word];
                seen.insert(word);
            }
        for (const uint32_t bin : seen) ++expected[256 + bin];
    }
    for (uint32_t bin = 0; bin < 256; ++bin) {
        check.expect(found[bin] == expected[bin],
                     fmt::format("count_together, {}: bin {} of the picture has {} pixels, expected {}", what, bin,
                                 found[bin], expected[bin]),
                     "own_bins to 0, barrier(), atomicAdd to one's own bin, barrier(), then each thread takes one bin "
                     "along; memoryBarrierShared() "
                     "is no barrier(), it waits for nobody");
        check.expect(found[256 + bin] <= expected[256 + bin],
                     fmt::format("count_together, {}: bin {} was added to {} times, at most {} are needed", what, bin,
                                 found[256 + bin], expected[256 + bin]),
                     "a workgroup adds to a bin once, and only where it counted something");
        if (check.failed > 0) return;
    }
    const auto raw = gpu.read_back(passed);
    std::vector<uint32_t> barriers(given.size());
    std::memcpy(barriers.data(), raw.data(), raw.size());
    for (uint32_t group = 0; group < most_groups; ++group) {
        const std::string wrong = barriers_wrong(std::span(barriers).subspan(256 * group, 256));
        check.expect(wrong.empty(), fmt::format("count_together, {}: {}", what, wrong), barrier_hint);
    }
}

}  // namespace

CHECK_EXERCISE("09.histogram_bin",
               "log2(luminance) + 12 is the number of stops. For the counting: clear, wait, count, wait, add.") {
    Random random;
    const double infinity = std::numeric_limits<double>::infinity();
    // Within a hundredth of a bin of a border either is right: logarithms on devices are.
    Probe probe{
        .include = "09_post_effects/histogram_bin.glsl",
        .signature = "uint histogram_bin(float luminance)",
        .inputs = {{0},
                   {-1},
                   {std::nan("")},
                   {1e-10},
                   {0.000243},
                   {0.18},
                   {1},
                   {4095},
                   {4096.5},
                   {65504},
                   {infinity},
                   {-infinity},
                   {1.0 / 4000}},
        .truth =
            [](std::span<const double> in) {
                if (!(in[0] >= 1.0 / 4096)) return Row{0};
                return Row{1 + std::min(std::floor(truth::histogram_position(in[0])), 254.0)};
            },
        .bound = {.absolute = 0.5},
        .hint = [](auto in, auto) -> std::string {
            if (!(in[0] >= 1.0 / 4096))
                return "0, negative numbers and NaN belong to bin 0; a comparison with NaN is false.";
            if (in[0] > 4096)
                return "Luminances beyond the last bin belong to it; converting infinity to an integer is undefined.";
            return "There are 255 bins for 24 stops, beginning with bin 1.";
        }};
    while (probe.inputs.size() < 500) {
        const double l = random.logarithmic(1.0 / 8192, 8192);
        const double at = truth::histogram_position(l);
        if (std::fabs(at - std::round(at)) > 0.01) probe.inputs.push_back({l});
    }
    check.probe(probe);
    if (check.failed > 0) return;

    std::vector<uint32_t> same(1024, 77), each, some, mixed;
    for (uint32_t i = 0; i < 1024; ++i) {
        each.push_back(255 - i % 256);
        some.push_back(i % 3 == 0 ? 999 : i % 5);
        mixed.push_back(i * 2654435761u >> 24);
    }
    count(check, "all pixels in one bin", same, 4);
    if (check.failed == 0) count(check, "each pixel in a bin of its own", each, 4);
    if (check.failed == 0) count(check, "a third of the threads without a pixel", some, 4);
    if (check.failed == 0) count(check, "bins at random", mixed, 4);
}
