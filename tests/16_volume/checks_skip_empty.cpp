// Checks of 16.skip_empty: a volume with known block ranges, and the barriers.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/gtc/packing.hpp>
#include <regex>

#include "16_volume/volume_data.h"
#include "common/check/barriers.h"
#include "common/check/check.h"
#include "common/gpu/frame.h"
#include "common/gpu/glsl.h"

using namespace lightwalk;

namespace {

// Shared memory is full of something else; the block comes from the group. Each invocation stands for another one
// (common/check/workgroup.h): as numbered, the last first, scattered, and neighbours far apart.
constexpr const char* harness = R"(
#include "16_volume/skip_empty.glsl"
layout(scalar) writeonly buffer PassedBuffer { uint passed[]; };
layout(scalar) writeonly buffer RacedBuffer { uint raced[]; };
layout(scalar) uniform OrderBlock { int order; };
void main() {
    uint i = gl_LocalInvocationID.x + 4u * gl_LocalInvocationID.y + 16u * gl_LocalInvocationID.z;
    uint[] places = uint[](i, 63u - i, (29u * i + 5u) % 64u, bitfieldReverse(i) >> 26u);
    check_stands_for = places[order];
    thread_ranges[check_stands_for] = check_kept[check_stands_for] = vec2(-9.0, 9.0);
    check_named_by[check_stands_for] = 0u;
    if (check_stands_for == 0u) check_raced = false;
    check_wait();
    skip_empty(ivec3(gl_WorkGroupID));
    check_barrier();
    uint group = gl_WorkGroupID.x + gl_NumWorkGroups.x * (gl_WorkGroupID.y + gl_NumWorkGroups.y * gl_WorkGroupID.z);
    if (check_stands_for == 0u) raced[group] = uint(check_raced);
    passed[64u * group + check_stands_for] = check_barriers_passed;
}
)";
constexpr int orders = 4;

// The exercise's invocations are called by another name; main()'s are not.
std::string source() {
    std::string text = flatten_text(harness, "check of skip_empty", "99", {}).text;
    const size_t mine = text.find("void main() {\n    uint i = ");
    std::string exercise = text.substr(text.find("#line 1 "), mine - text.find("#line 1 "));
    static const std::regex index(R"(\bgl_LocalInvocationIndex\b)"), id(R"(\bgl_LocalInvocationID\b)");
    exercise = std::regex_replace(exercise, index, "check_stands_for");
    exercise = std::regex_replace(exercise, id,
                                  "(uvec3(check_stands_for, check_stands_for / 4u, check_stands_for / 16u) % 4u)");
    const Raced raced = traced_races(exercise, "thread_ranges", "vec2", 64);
    return raced.before + raced.text + raced.after + text.substr(mine);
}

struct Voxels {
    glm::ivec3 size;
    std::vector<float> values;
    float at(glm::ivec3 p) const {
        p = glm::clamp(p, glm::ivec3(0), size - 1);
        const float value = values[size_t(p.x + size.x * (p.y + size.y * p.z))];
        return value > 0 ? value : 0;
    }
};

// `faces`: without what lies beyond an edge or a corner.
glm::vec2 range_of(const Voxels& voxels, glm::ivec3 block, int border, bool faces = false) {
    glm::vec2 range(65504.0f, 0.0f);
    const int edge = BLOCK_VOXELS + border;
    for (int z = -border; z < edge; ++z)
        for (int y = -border; y < edge; ++y)
            for (int x = -border; x < edge; ++x) {
                const auto beyond = [](int i) { return i < 0 || i >= BLOCK_VOXELS ? 1 : 0; };
                if (faces && beyond(x) + beyond(y) + beyond(z) > 1) continue;
                const float value = voxels.at(block * BLOCK_VOXELS + glm::ivec3(x, y, z));
                range = {std::min(range.x, value), std::max(range.y, value)};
            }
    return range;
}

// What common mistakes make of a block, and else the order in which threads come.
std::string hint_for(const Voxels& voxels, glm::ivec3 block, int border, glm::vec2 got, bool reordered) {
    if (std::ranges::any_of(voxels.values, [](float value) { return std::isnan(value); }))
        return "a density that is NaN counts as 0; min() and max() may keep it, or leave it out";
    if (got.x == 1 || got.y == 1) return "a density may be above 1: begin with a number that none exceeds";
    if (reordered)
        return "with the threads in another order: is there a barrier() between each writing to thread_ranges and the "
               "reading by another thread?";
    if (got == range_of(voxels, block, 0))
        return "that is the block without the voxels beyond its faces, which samples in it mix with";
    if (border > 1 && got == range_of(voxels, block, 1)) return "`border` voxels beyond each face, and not one";
    if (got == range_of(voxels, block, border, true))
        return "voxels beyond an edge or a corner of the block count too: along all three axes at once";
    return "each voxel by some thread, all ranges into thread_ranges, barrier(), then half as many threads at a time";
}

void try_blocks(Check& check, const std::string& what, const Voxels& voxels, int border) {
    Gpu& gpu = check_device();
    const Pipeline pipeline = compute({.shader = "check of skip_empty", .macros = {}, .source = source()});
    std::vector<uint16_t> halves;
    for (const float value : voxels.values) halves.push_back(glm::packHalf1x16(value));
    const glm::ivec3 blocks = (voxels.size + BLOCK_VOXELS - 1) / BLOCK_VOXELS;
    Image image(gpu.device, {.name = "voxels",
                             .format = VK_FORMAT_R16_SFLOAT,
                             .size = {uint32_t(voxels.size.x), uint32_t(voxels.size.y)},
                             .depth = uint32_t(voxels.size.z)});
    gpu.upload(image, std::as_bytes(std::span(halves)));
    const Image ranges(gpu.device, {.name = "ranges",
                                    .format = VK_FORMAT_R16G16_SFLOAT,
                                    .size = {uint32_t(blocks.x), uint32_t(blocks.y)},
                                    .depth = uint32_t(blocks.z),
                                    .kept = true});
    const size_t groups = size_t(blocks.x) * size_t(blocks.y) * size_t(blocks.z);
    const Buffer passed(gpu.device, {.name = "passed", .bytes = 64 * 4 * groups});
    const Buffer races(gpu.device, {.name = "races", .bytes = 4 * groups});
    for (int order = 0; order < orders; ++order) {
        Frame frame(gpu);
        frame.begin({4, 4}, 0);
        frame.compute("blocks", {.reads = {image}, .writes = {ranges, passed, races}}, [&](Compute& pass) {
            pass.use(pipeline).set("voxels", image, nearest_clamp).set("ranges", ranges).set("border", border);
            pass.set("order", order).set("passed", passed).set("raced", races).dispatch(glm::uvec3(blocks));
        });
        frame.end();
        const auto bytes = gpu.read_back(ranges);
        std::vector<uint32_t> found(groups);
        std::memcpy(found.data(), bytes.data(), 4 * groups);
        for (size_t i = 0; i < groups; ++i) {
            const glm::ivec3 block(int(i) % blocks.x, int(i) / blocks.x % blocks.y, int(i) / (blocks.x * blocks.y));
            const glm::vec2 got = glm::unpackHalf2x16(found[i]), right = range_of(voxels, block, border);
            check.expect(got == right,
                         fmt::format("{}, a border of {}: block ({}, {}, {}) has the range {:.4f} to {:.4f}, expected "
                                     "{:.4f} to {:.4f}",
                                     what, border, block.x, block.y, block.z, got.x, got.y, right.x, right.y),
                         got == right ? "" : hint_for(voxels, block, border, got, order > 0));
            if (check.failed) return;
        }
        std::vector<uint32_t> raced(groups);
        const auto noted = gpu.read_back(races);
        std::memcpy(raced.data(), noted.data(), 4 * groups);
        check.expect(std::ranges::count(raced, 0u) == std::ptrdiff_t(groups),
                     what +
                         ": one thread writes an element of thread_ranges that another one names before the next "
                         "barrier(): which of the two comes first is left to the device",
                     "the result too is read by other threads than the one that wrote it: after a barrier(), or by "
                     "thread 0 alone");
        if (check.failed) return;
        const auto raw = gpu.read_back(passed);
        std::vector<uint32_t> barriers(64 * groups);
        std::memcpy(barriers.data(), raw.data(), raw.size());
        for (size_t group = 0; group < groups; ++group) {
            const std::string wrong = barriers_wrong(std::span(barriers).subspan(64 * group, 64));
            check.expect(wrong.empty(), fmt::format("{}: {}", what, wrong), barrier_hint);
            if (check.failed) return;
        }
    }
}

}  // namespace

CHECK_EXERCISE("16.skip_empty",
               "each thread some of the voxels, border and all; then 64 ranges become one in 6 rounds") {
    Random random(8);
    const auto volume = [&](glm::ivec3 size, const auto& value) {
        Voxels voxels{size, {}};
        for (int z = 0; z < size.z; ++z)
            for (int y = 0; y < size.y; ++y)
                for (int x = 0; x < size.x; ++x)
                    voxels.values.push_back(glm::unpackHalf1x16(glm::packHalf1x16(value(glm::ivec3(x, y, z)))));
        return voxels;
    };
    const glm::ivec3 odd(19, 16, 11);
    // One voxel alone beside a face: only a border lets the block on the other side know of it.
    const glm::ivec3 alone(8, 3, 3), diagonal(8, 8, 8);
    for (const int border : {1, 2, 3}) {
        try_blocks(check, "one voxel that is full", volume(odd, [&](glm::ivec3 p) { return p == alone ? 1.0f : 0.0f; }),
                   border);
        if (check.failed) return;
        try_blocks(check, "one voxel that is empty",
                   volume(odd, [&](glm::ivec3 p) { return p == alone ? 0.0f : 0.5f; }), border);
        if (check.failed) return;
        try_blocks(check, "one full voxel beyond the corner of a block",
                   volume(odd, [&](glm::ivec3 p) { return p == diagonal ? 1.0f : 0.5f; }), border);
        if (check.failed) return;
        // The outermost voxel that counts along two and three axes, and the one behind it.
        for (const int beyond : {0, 1}) {
            for (const glm::ivec3 axes :
                 {glm::ivec3(1, 1, 0), glm::ivec3(0, 1, 1), glm::ivec3(1, 0, 1), glm::ivec3(1)}) {
                for (const bool before : {true, false}) {
                    const glm::ivec3 outermost =
                        glm::ivec3(BLOCK_VOXELS) + axes * (before ? -border - beyond : border - 1 + beyond);
                    if (outermost.z >= odd.z) continue;
                    try_blocks(check,
                               fmt::format("one full voxel {} {}", beyond ? "behind the border" : "at the border's end",
                                           before ? "before a block" : "after a block"),
                               volume(odd, [&](glm::ivec3 p) { return p == outermost ? 1.0f : 0.5f; }), border);
                    if (check.failed) return;
                }
            }
        }
        try_blocks(check, "random voxels", volume(odd, [&](glm::ivec3) { return float(random.uniform(0, 1)); }),
                   border);
        if (check.failed) return;
    }
    try_blocks(check, "densities above 1", volume(odd, [&](glm::ivec3) { return float(random.uniform(2, 9)); }), 1);
    if (check.failed) return;
    try_blocks(check, "a volume of 1x1x20", volume({1, 1, 20}, [](glm::ivec3 p) { return float(p.z) / 20; }), 1);
    if (check.failed) return;
    try_blocks(check, "a voxel that is no number", volume(odd, [&](glm::ivec3 p) { return p == alone ? NAN : 0.25f; }),
               1);
}
