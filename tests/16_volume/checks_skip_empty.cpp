// Checks of 16.skip_empty: a volume with known block ranges, and the barriers.
#include <fmt/core.h>

#include <cstring>
#include <glm/gtc/packing.hpp>

#include "16_volume/volume_data.h"
#include "common/check/barriers.h"
#include "common/check/check.h"
#include "common/gpu/frame.h"

using namespace lightwalk;

namespace {

// Shared memory is full of something else; the block comes from the group.
constexpr const char* harness = R"(
#include "16_volume/skip_empty.glsl"
layout(scalar) writeonly buffer PassedBuffer { uint passed[]; };
void main() {
    thread_ranges[gl_LocalInvocationIndex] = vec2(-9.0, 9.0);
    check_barrier();
    skip_empty(ivec3(gl_WorkGroupID));
    uint group = gl_WorkGroupID.x + gl_NumWorkGroups.x * (gl_WorkGroupID.y + gl_NumWorkGroups.y * gl_WorkGroupID.z);
    passed[64u * group + gl_LocalInvocationIndex] = check_barriers_passed;
}
)";

struct Voxels {
    glm::ivec3 size;
    std::vector<float> values;
    float at(glm::ivec3 p) const {
        p = glm::clamp(p, glm::ivec3(0), size - 1);
        const float value = values[size_t(p.x + size.x * (p.y + size.y * p.z))];
        return value > 0 ? value : 0;
    }
};

glm::vec2 range_of(const Voxels& voxels, glm::ivec3 block, int border) {
    glm::vec2 range(65504.0f, 0.0f);
    const int edge = BLOCK_VOXELS + border;
    for (int z = -border; z < edge; ++z)
        for (int y = -border; y < edge; ++y)
            for (int x = -border; x < edge; ++x) {
                const float value = voxels.at(block * BLOCK_VOXELS + glm::ivec3(x, y, z));
                range = {std::min(range.x, value), std::max(range.y, value)};
            }
    return range;
}

void try_blocks(Check& check, const std::string& what, const Voxels& voxels, int border) {
    Gpu& gpu = check_device();
    const Pipeline pipeline =
        compute({.shader = "check of skip_empty", .macros = {}, .source = traced_barriers() + harness});
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
    Frame frame(gpu);
    frame.begin({4, 4}, 0);
    frame.compute("blocks", {.reads = {image}, .writes = {ranges, passed}}, [&](Compute& pass) {
        pass.use(pipeline).set("voxels", image, nearest_clamp).set("ranges", ranges).set("border", border);
        pass.set("passed", passed).dispatch(glm::uvec3(blocks));
    });
    frame.end();
    const auto bytes = gpu.read_back(ranges);
    std::vector<uint32_t> found(groups);
    std::memcpy(found.data(), bytes.data(), 4 * groups);
    for (size_t i = 0; i < groups; ++i) {
        const glm::ivec3 block(int(i) % blocks.x, int(i) / blocks.x % blocks.y, int(i) / (blocks.x * blocks.y));
        const glm::vec2 got = glm::unpackHalf2x16(found[i]), right = range_of(voxels, block, border);
        const glm::vec2 bare = range_of(voxels, block, 0);
        check.expect(
            got == right,
            fmt::format("{}, a border of {}: block ({}, {}, {}) has the range {:.4f} to {:.4f}, expected {:.4f} "
                        "to {:.4f}",
                        what, border, block.x, block.y, block.z, got.x, got.y, right.x, right.y),
            what.find("no number") != what.npos
                ? "a density that is NaN counts as 0; min() and max() may keep it, or leave it out"
            : got == bare ? "that is the block without the voxels beyond its faces, which samples in it mix with"
                          : "each voxel by some thread, all ranges into thread_ranges, barrier(), then half as many "
                            "threads at a time");
        if (check.failed) return;
    }
    const auto raw = gpu.read_back(passed);
    std::vector<uint32_t> barriers(64 * groups);
    std::memcpy(barriers.data(), raw.data(), raw.size());
    for (size_t group = 0; group < groups; ++group) {
        const std::string wrong = barriers_wrong(std::span(barriers).subspan(64 * group, 64));
        check.expect(wrong.empty(), fmt::format("{}: {}", what, wrong), barrier_hint);
        if (check.failed) return;
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
    const glm::ivec3 odd(19, 16, 9);
    // One voxel alone beside a face: only a border lets the block on the other side know of it.
    const glm::ivec3 alone(8, 3, 3);
    for (const int border : {1, 2, 3}) {
        try_blocks(check, "one voxel that is full", volume(odd, [&](glm::ivec3 p) { return p == alone ? 1.0f : 0.0f; }),
                   border);
        if (check.failed) return;
        try_blocks(check, "one voxel that is empty",
                   volume(odd, [&](glm::ivec3 p) { return p == alone ? 0.0f : 0.5f; }), border);
        if (check.failed) return;
        try_blocks(check, "random voxels", volume(odd, [&](glm::ivec3) { return float(random.uniform(0, 1)); }),
                   border);
        if (check.failed) return;
    }
    try_blocks(check, "a volume of 1x1x20", volume({1, 1, 20}, [](glm::ivec3 p) { return float(p.z) / 20; }), 1);
    if (check.failed) return;
    try_blocks(check, "a voxel that is no number", volume(odd, [&](glm::ivec3 p) { return p == alone ? NAN : 0.25f; }),
               1);
}
