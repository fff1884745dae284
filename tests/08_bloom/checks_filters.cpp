// Checks of chapter 08's filters: the response to one bright texel, and a whole workgroup.
#include <fmt/core.h>

#include <cmath>
#include <glm/gtc/packing.hpp>

#include "common/check/barriers.h"
#include "common/check/check.h"
#include "common/gpu/frame.h"

using namespace lightwalk;

CHECK_EXERCISE(
    "08.down_filter",
    "Five squares of four reads each; a read that several squares share is done once, with the sum of its weights.") {
    glm::dvec2 mean(0), square(0);
    for (const glm::ivec2 impulse : {glm::ivec2{8, 8}, {9, 8}, {8, 9}, {9, 9}}) {
        Probe probe{.include = "08_bloom/down_filter.glsl",
                    .before = "#include \"../tests/08_bloom/known_level.glsl\"\n",
                    .signature = "vec3 down_filter(ivec2 at)",
                    .truth =
                        [](std::span<const double>) {
                            return Row{0, 0, 0};
                        },
                    .bound = {.absolute = 1e9},  // many filters are right: later checks decide
                    .macros = {{"IMPULSE_X", std::to_string(impulse.x)}, {"IMPULSE_Y", std::to_string(impulse.y)}}};
        for (int y = 0; y <= 8; ++y)
            for (int x = 0; x <= 8; ++x) probe.inputs.push_back({double(x), double(y)});
        const Table results = check.probe(probe);
        if (results.empty()) return;
        double sum = 0, least = 0;
        for (size_t i = 0; i < results.size(); ++i) {
            const double weight = results[i][1];
            // Where the texel's middle lies, from the impulse's, in texels of the level above.
            const glm::dvec2 way = 2.0 * glm::dvec2(probe.inputs[i][0], probe.inputs[i][1]) + 0.5 - glm::dvec2(impulse);
            sum += weight;
            mean += weight * way;
            square += weight * way * way;
            least = std::min(least, weight);
        }
        const std::string which =
            fmt::format("a lone bright texel at ({}, {}) of the level above", impulse.x, impulse.y);
        check.expect(
            std::fabs(sum - 0.25) < 1e-4,
            fmt::format("{} gives {:.4f} of its light to this level, expected 0.25", which, sum),
            "a quarter of the texels must hold all of the light: weights that add up to 1 are not enough, each "
            "texel above must get the same, wherever it lies");
        check.expect(least > -1e-6, fmt::format("{} gets a weight of {:.4f}, below 0", which, least));
    }
    // Mean over the four positions of a texel in a square of two by two, a quarter each.
    check.expect(glm::length(mean) < 0.02,
                 fmt::format("bright texels are moved by ({:.2f}, {:.2f}) of the level above", mean.x, mean.y),
                 "offsets are from the middle of `at`: to each there is one on the other side");
    for (int axis = 0; axis < 2; ++axis)
        check.expect(std::fabs(square[axis] - 1.75) < 0.05,
                     fmt::format("bright texels are blurred with a variance of {:.3f} square texels along {}, expected "
                                 "1.75",
                                 square[axis], axis ? "y" : "x"),
                     square[axis] < 1.5 ? "The filter is too narrow: a moving texel flickers." : "");
}

namespace {

// Four workgroups on a known line, each compared with a plain loop.
constexpr const char* harness = R"(
layout(local_size_x = 256) in;
#include "../tests/08_bloom/known_line.glsl"
layout(scalar) uniform RadiusBlock { int radius; };
// Before the answer: replacements for GLSL's own functions that it may call.
void check_begin() {
    check_base = 256 * int(gl_WorkGroupID.x);
    for (int slot = int(gl_LocalInvocationIndex); slot < most_kept; slot += threads) keep_texel(slot, vec3(-777.0));
    check_barrier();
}
float check_plainly(int own, int radius) {
    float expected = 0.0;
    for (int k = -radius; k <= radius; ++k)
        expected += weight_at(abs(k)) * texelFetch(check_known, ivec2(own + k + 1024, 0), 0).g;
    return expected;
}
#include "08_bloom/blur_line.glsl"
struct Answer { float got, expected; uint barriers; };
layout(scalar) writeonly buffer AnswerBuffer { Answer answers[]; };
void main() {
    check_begin();
    int own = check_base + int(gl_LocalInvocationIndex);
    vec3 got = blur_line(256 * int(gl_WorkGroupID.x), radius);
    uint barriers = check_barriers_passed;
    answers[own] = Answer(got.g, check_plainly(own, radius), barriers);
}
)";

struct Answer {
    float got, expected;
    uint32_t barriers;
};

void compare(Check& check, uint32_t group, int radius) {
    Gpu& gpu = check_device();
    const Pipeline pipeline = compute({.shader = "check of blur_line", .source = traced_barriers() + harness});
    const Image known(gpu.device, {.name = "known", .size = {3072, 1}});
    std::vector<uint64_t> texels;
    uint32_t n = 7 + check_seed();
    for (int i = 0; i < 3072; ++i) {
        n = n * 1664525u + 1013904223u;
        texels.push_back(glm::packHalf4x16(glm::vec4(float(n >> 24) / 64.0f)));
    }
    const Buffer counts = gpu.upload("counts", std::vector<uint32_t>(2100, 0));
    const Buffer answers(gpu.device, {.name = "answers", .bytes = 1024 * sizeof(Answer)});
    Frame frame(gpu);
    frame.begin({4, 4}, 0);
    frame.upload("known", known, std::as_bytes(std::span(texels)));
    frame.compute("line", {.reads = {known, counts}, .writes = {counts, answers}}, [&](Compute& pass) {
        pass.use(pipeline).set("check_known", known, nearest_clamp).set("check_counts", counts).set("answers", answers);
        pass.set("radius", radius).dispatch({group + 1, 1, 1});
    });
    frame.end();
    const auto bytes = gpu.read_back(answers);
    std::vector<Answer> found(1024);
    std::memcpy(found.data(), bytes.data(), 1024 * sizeof(Answer));
    for (uint32_t i = 256 * group; i < 256 * (group + 1); ++i) {
        const float allowed = 2e-4f * found[i].expected + 1e-4f;
        const bool right = std::fabs(found[i].got - found[i].expected) <= allowed;
        check.expect(
            right,
            fmt::format("blur_line(start = {}, radius = {}): thread {} gave {:.4f}, expected {:.4f}", 256 * group,
                        radius, i - 256 * group, found[i].got, found[i].expected),
            found[i].got < 0
                ? "A slot was read before a texel was stored in it: every slot must be filled, and barrier() must "
                  "stand before the reads (memoryBarrierShared() does not wait)."
                : "Slot s holds texel(start - radius + s): the texel of thread t itself is in slot t + radius.");
        if (!right) return;
    }
    std::vector<uint32_t> passed;
    for (uint32_t i = 256 * group; i < 256 * (group + 1); ++i) passed.push_back(found[i].barriers);
    const std::string wrong = barriers_wrong(passed);
    check.expect(wrong.empty(), fmt::format("blur_line(start = {}, radius = {}): {}", 256 * group, radius, wrong),
                 barrier_hint);
    if (group > 0 || !wrong.empty()) return;
    const auto raw = gpu.read_back(counts);
    std::vector<uint32_t> reads(2100);
    std::memcpy(reads.data(), raw.data(), reads.size() * 4);
    for (int i = -radius; i < 256 + radius; ++i) {
        const uint32_t times = reads[static_cast<size_t>(i + 900)];
        check.expect(
            times == 1,
            fmt::format("blur_line(start = 0, radius = {}) read texel({}) {} times, expected once", radius, i, times),
            "one thread reads a texel and keeps it; all others take it from shared memory");
        if (times != 1) return;
    }
    uint32_t all = 0;
    for (const uint32_t times : reads) all += times;
    check.expect(
        all == uint32_t(256 + 2 * radius),
        fmt::format("blur_line(start = 0, radius = {}) read {} texels, expected {}", radius, all, 256 + 2 * radius),
        "nobody needs what lies more than the radius beyond the workgroup's own texels");
}

}  // namespace

CHECK_EXERCISE("08.blur_line", "A loop in which each thread stores every 256th texel, then barrier(), then the sum.") {
    for (const int radius : {0, 1, 7, 100, 128, 129, 300, 896}) compare(check, 0, radius);
    compare(check, 2, 50);
}
