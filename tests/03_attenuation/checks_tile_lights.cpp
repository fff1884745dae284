// Checks of 03.tile_lights: tiles and lights from a table, in several orders of the invocations.
#include <bit>

#include "common/check/barriers.h"
#include "common/check/check.h"
#include "common/check/guard.h"
#include "common/check/workgroup.h"
#include "common/gpu/glsl.h"

using namespace lightwalk;

namespace {

constexpr uint32_t most_pixels = 1024, most_lights = 3072, groups = 3, mask_words = most_lights / 32;
constexpr uint32_t stride = 2 + most_pixels + mask_words;

struct Tile {
    std::string words;
    std::vector<float> depths;
    std::vector<bool> reaches;  ///< by light

    std::pair<float, float> range() const {
        float farthest = 1, nearest = 0;
        for (const float depth : depths)
            if (depth > 0) {
                farthest = std::min(farthest, depth);
                nearest = std::max(nearest, depth);
            }
        return {farthest, nearest};
    }
    uint32_t mask(uint32_t m) const {
        uint32_t bits = 0;
        for (uint32_t i = 0; i < 32; ++i)
            if (32 * m + i < reaches.size() && reaches[32 * m + i]) bits |= 1u << i;
        return bits;
    }
};

std::vector<Tile> tiles() {
    Random random(3);
    const auto depths = [&](size_t count, double background) {
        std::vector<float> all(count);
        for (float& depth : all)
            depth = random.uniform(0, 1) < background ? 0.0f : static_cast<float>(random.uniform(0.1, 0.9));
        return all;
    };
    const auto some = [&](size_t count, double share) {
        std::vector<bool> all(count);
        for (size_t i = 0; i < count; ++i) all[i] = random.uniform(0, 1) < share;
        return all;
    };
    std::vector<float> last(256, 0.5f);
    last[254] = 0.25f;
    last[255] = 0.75f;
    std::vector<bool> only_last(1025);
    only_last[1024] = true;
    return {{"256 pixels of background, no light", std::vector<float>(256, 0.0f), {}},
            {"256 pixels at depth 0.5, one light", std::vector<float>(256, 0.5f), {true}},
            {"256 pixels at depth 0.5 but the last two, 33 lights", last, some(33, 1)},
            {"256 pixels, half of them background, 70 lights", depths(256, 0.5), some(70, 0.5)},
            {"100 pixels, 300 lights", depths(100, 0), some(300, 0.5)},
            {"1024 pixels, 1000 lights", depths(1024, 0.3), some(1000, 0.3)},
            {"256 pixels, 1024 lights that all reach", depths(256, 0), some(1024, 1)},
            {"256 pixels, 1025 lights of which the last reaches", depths(256, 0), only_last},
            {"256 pixels, 2500 lights", depths(256, 0.9), some(2500, 0.5)}};
}

WorkgroupRun run_of(const std::vector<Tile>& all) {
    WorkgroupRun run{.include = "03_attenuation/tile_lights.glsl",
                     .before = "const uint TILE_INVOCATIONS = 256u, tile_stride = " + std::to_string(stride) +
                               "u;\n"
                               "uint tile_pixels() { return given[case_index * tile_stride]; }\n"
                               "uint light_count() { return given[case_index * tile_stride + 1u]; }\n"
                               "float tile_depth(uint p) { return p >= tile_pixels() ? 0.05 : "
                               "uintBitsToFloat(given[case_index * tile_stride + 2u + p]); }\n"
                               "bool light_reaches_tile(uint i) { return i >= light_count() || (given[case_index * "
                               "tile_stride + 2u + " +
                               std::to_string(most_pixels) + "u + i / 32u] >> i % 32u & 1u) != 0u; }\n",
                     .call =
                         "vec2 range = tile_depth_range(local);\n"
                         "put(0u, floatBitsToUint(range.x));\nput(1u, floatBitsToUint(range.y));\n"
                         "for (uint group = 0u; group < (light_count() + 1023u) / 1024u; ++group) {\n"
                         "    find_tile_lights(local, group);\n"
                         "    put(2u + group, tile_masks[local % 32u]);\n}\n",
                     .given = {},
                     .cases = static_cast<uint32_t>(all.size()),
                     .puts = 2 + groups};
    for (const Tile& tile : all) {
        run.given.push_back(static_cast<uint32_t>(tile.depths.size()));
        run.given.push_back(static_cast<uint32_t>(tile.reaches.size()));
        for (uint32_t i = 0; i < most_pixels; ++i)
            run.given.push_back(std::bit_cast<uint32_t>(i < tile.depths.size() ? tile.depths[i] : 0.0f));
        for (uint32_t m = 0; m < mask_words; ++m) run.given.push_back(tile.mask(m));
    }
    return run;
}

const char* const hint_range =
    "floats above 0 and their bits have one order: atomicMin and atomicMax of floatBitsToUint; depth 0 does not count";
const char* const hint_barrier =
    "set, barrier, add, barrier, read: between any two of them another invocation may still be at the one before; and "
    "a "
    "new call begins while others read what the last one left";

enum class Saw { right, wrong, nothing };

// `saw` holds an invocation's values in one order. If only some saw a wrong one, a barrier is missing.
template <class Function>
void judge(Check& check, const std::string& wrong_words, const char* hint, const Function& saw) {
    uint32_t count[3] = {}, order = 0, local = 0;
    for (uint32_t o = 0; o < workgroup_orders; ++o)
        for (uint32_t l = 0; l < workgroup_size; ++l)
            if (const Saw one = saw(o, l); count[static_cast<int>(one)]++ == 0 && one == Saw::wrong) {
                order = o;
                local = l;
            }
    const bool some = count[static_cast<int>(Saw::right)] > 0;
    const std::string who = "; so saw invocation " + std::to_string(local) +
                            (order ? ", when they ran in another order" : "") +
                            ", and others saw what is right: a barrier is missing, or what one of them found is lost";
    check.expect(count[static_cast<int>(Saw::wrong)] == 0, some ? wrong_words + who : wrong_words,
                 some ? hint_barrier : hint);
}

}  // namespace

CHECK_EXERCISE("03.tile_lights", hint_barrier) {
    const std::vector<Tile> all = tiles();
    guard_call("tile_lights.glsl, as a workgroup of 256");
    const WorkgroupResults seen(check_device(), run_of(all));
    guard_call("");
    for (uint32_t i = 0; i < all.size(); ++i) {
        const auto [farthest, nearest] = all[i].range();
        const auto depth = [&](uint32_t order, uint32_t local, uint32_t at) {
            return std::bit_cast<float>(seen.at(i, order, local, at));
        };
        const auto pair = [](float a, float b) {
            return "(" + number_text(double(a)) + ", " + number_text(double(b)) + ")";
        };
        const auto saw_range = [&](uint32_t o, uint32_t l) {
            return depth(o, l, 0) == farthest && depth(o, l, 1) == nearest ? Saw::right : Saw::wrong;
        };
        std::string gave;
        for (uint32_t o = 0; o < workgroup_orders; ++o)
            for (uint32_t l = 0; l < workgroup_size; ++l)
                if (gave.empty() && saw_range(o, l) == Saw::wrong) gave = pair(depth(o, l, 0), depth(o, l, 1));
        judge(check,
              all[i].words + ": tile_depth_range gave " + gave + ", expected " + pair(farthest, nearest) +
                  " (farthest, nearest)",
              hint_range, saw_range);
        for (uint32_t m = 0; m < (all[i].reaches.size() + 31) / 32; ++m) {
            const uint32_t wanted = all[i].mask(m);
            const auto differs = [&](uint32_t o, uint32_t l) { return seen.at(i, o, l, 2 + m / 32) ^ wanted; };
            uint32_t wrong = 0;  // bits of the first reader that saw another mask
            for (uint32_t o = 0; o < workgroup_orders && !wrong; ++o)
                for (uint32_t l = m % 32; l < workgroup_size && !wrong; l += 32) wrong = differs(o, l);
            const uint32_t light = 32 * m + (wrong ? static_cast<uint32_t>(std::countr_zero(wrong)) : 0);
            const std::string number = std::to_string(light);
            judge(
                check,
                all[i].words + ": " +
                    (light >= all[i].reaches.size() ? "there is no light " + number + ", its bit is 1"
                     : all[i].reaches[light]        ? "light " + number + " reaches the tile, its bit is 0"
                                                    : "light " + number + " does not reach the tile, its bit is 1"),
                "light 1024 * group + 32 * m + i is bit i of tile_masks[m]; 256 invocations go on, each by 256, until "
                "no light of the group is left",
                [&](uint32_t o, uint32_t l) {
                    return l % 32 != m % 32 ? Saw::nothing : differs(o, l) ? Saw::wrong : Saw::right;
                });
        }
    }
    const std::string wrong = seen.barriers();
    check.expect(wrong.empty(), "tile_lights: " + wrong, barrier_hint);
}
