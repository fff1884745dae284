// Checks of the exercises about the ground.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <set>

#include "15_terrain_water/land_data.h"
#include "common/check/check.h"
#include "common/gpu/frame.h"

using namespace lightwalk;

namespace {

// ---- 15.height_blend

Row blended(std::span<const double> in) {
    double top = -1e9, sum = 0;
    for (size_t i = 0; i < 4; ++i)
        if (in[i] > 0) top = std::max(top, in[i] + in[4 + i]);
    Row shares;
    for (size_t i = 0; i < 4; ++i) {
        shares.push_back(in[i] > 0 ? in[i] * std::max(in[i] + in[4 + i] - top + in[8], 0.0) : 0.0);
        sum += shares.back();
    }
    for (double& share : shares) share /= sum;
    return shares;
}

}  // namespace

CHECK_EXERCISE("15.height_blend", "The greatest weight plus height among the materials that are there decides.") {
    Probe probe{.include = "15_terrain_water/height_blend.glsl",
                .signature = "vec4 height_blend(vec4 weights, vec4 heights, float softness)",
                .inputs = {{1, 0, 0, 0, 0.5, 0.5, 0.5, 0.5, 0.2},
                           {0.5, 0.5, 0, 0, 0.2, 0.8, 0.5, 0.5, 0.2},
                           {0.5, 0.5, 0, 0, 0.5, 0.5, 0.5, 0.5, 0.2},
                           {0.5, 0.5, 0, 0, 0.1, 0.2, 1, 1, 0.05},
                           {0.01, 0.99, 0, 0, 1, 0, 0, 1, 0.3},
                           {0.25, 0.25, 0.25, 0.25, 0, 0.1, 0.2, 0.3, 1},
                           {0.001, 0.999, 0, 0, 1, 0, 0, 0, 0.001},  // little, and above all the same
                           {0, 0, 0, 1, 1, 1, 1, 0, 0.01}},
                .truth = blended,
                .bound = {.absolute = 1e-3},
                .hint = [](auto in, auto out) -> std::string {
                    double sum = 0;
                    for (size_t i = 0; i < 4; ++i) {
                        sum += out[i];
                        if (in[i] == 0 && out[i] > 1e-4) return "A material of weight 0 is not there.";
                    }
                    if (!(std::fabs(sum - 1) < 1e-3)) return "The shares are scaled so that their sum is 1.";
                    if (std::fabs(out[0] - in[0]) + std::fabs(out[1] - in[1]) < 1e-4)
                        return "The heights have had no say.";
                    return "Look for the top among materials whose weight is above 0, and weigh what is above top - "
                           "softness by the weight.";
                }};
    Random random(15);
    while (probe.inputs.size() < 400) {
        Row row;
        double sum = 0;
        for (int i = 0; i < 4; ++i) {
            row.push_back(random.uniform(0, 1) < 0.35 ? 0 : random.uniform(0.02, 1));
            sum += row.back();
        }
        if (sum == 0) continue;
        for (double& weight : row) weight /= sum;
        for (int i = 0; i < 4; ++i) row.push_back(random.uniform(0, 1));
        row.push_back(random.logarithmic(0.02, 1));
        probe.inputs.push_back(row);
    }
    check.probe(probe);
}

// ---- 15.chunk_level

namespace {

/// A map of 2^top chunks along a side, and a view of it.
struct ChunkTrial {
    const char* what;
    int top;
    glm::vec3 eye;
    float metres_per_m;
    glm::mat4 to_clip{0.0f};  ///< all in view, unless it says otherwise
    float finest_error = 0;   ///< of every chunk of level 0
    float error = 0;          ///< of every other one; 0: any
};

struct ChunkView {
    glm::mat4 to_clip;
    glm::vec3 from;
    float metres_per_m;
    int fixed_level;
};

using Key = std::tuple<int, int, int>;  // level, x, z

class ChunkMap {
  public:
    ChunkMap(const ChunkTrial& trial, Random& random) : trial_(trial), errors_(size_t(trial.top) + 1) {
        for (int level = 0; level <= trial.top; ++level) {
            const int side = 1 << (trial.top - level);
            for (int z = 0; z < side; ++z)
                for (int x = 0; x < side; ++x) {
                    const float any = float(random.logarithmic(0.1, 3)) * float(1 << level);
                    float error = level == 0 ? trial.finest_error : trial.error > 0 ? trial.error : any;
                    for (int i = 0; i < 4 && level > 0; ++i)
                        error = std::max(error, at(2 * x + (i & 1), 2 * z + (i >> 1), level - 1));
                    errors_[size_t(level)].push_back(error);
                }
        }
    }
    float at(int x, int z, int level) const {
        const int last = (1 << (trial_.top - level)) - 1;
        return errors_[size_t(level)][size_t(std::clamp(z, 0, last) * (last + 1) + std::clamp(x, 0, last))];
    }
    const std::vector<float>& level(int i) const { return errors_[size_t(i)]; }

    bool split(int x, int z, int level) const {
        if (level == 0) return false;
        const float error = at(x, z, level);
        const glm::vec3 low = corner(x, z, level), high = low + glm::vec3(side_m(level), 0, side_m(level));
        const glm::vec3 away = glm::max(glm::max(low - trial_.eye, trial_.eye - high), glm::vec3(0));
        return error > glm::length(away) * trial_.metres_per_m;
    }
    bool in_view(int x, int z, int level) const {
        glm::ivec3 below(0), above(0);
        for (int i = 0; i < 4; ++i) {
            const glm::vec3 p = corner(x, z, level) + side_m(level) * glm::vec3(i & 1, 0, i >> 1);
            const glm::vec4 c = trial_.to_clip * glm::vec4(p, 1);
            below += glm::ivec3(c.x < -c.w, c.y < -c.w, c.z < 0);
            above += glm::ivec3(c.x > c.w, c.y > c.w, c.z > c.w);
        }
        return glm::all(glm::lessThan(glm::max(below, above), glm::ivec3(4)));
    }
    std::set<Key> drawn() const {
        std::set<Key> all;
        for (int level = trial_.top; level >= 0; --level)
            for (int z = 0; z < 1 << (trial_.top - level); ++z)
                for (int x = 0; x < 1 << (trial_.top - level); ++x) {
                    const bool asked = level == trial_.top || split(x / 2, z / 2, level + 1);
                    if (asked && !split(x, z, level) && in_view(x, z, level)) all.insert({level, x, z});
                }
        return all;
    }
    static float side_m(int level) { return float(CHUNK_CELLS << level); }

  private:
    glm::vec3 corner(int x, int z, int level) const {
        const float half = 0.5f * side_m(trial_.top);
        return {side_m(level) * float(x) - half, 0, side_m(level) * float(z) - half};
    }
    const ChunkTrial trial_;
    std::vector<std::vector<float>> errors_;
};

std::set<Key> run_chunks(const ChunkTrial& trial, const ChunkMap& map, uint32_t& count, bool& twice) {
    Gpu& gpu = check_device();
    static const Pipeline pipeline = compute({.shader = "15_terrain_water/cull_chunks.comp"});
    const uint32_t top = uint32_t(trial.top), cells = uint32_t(CHUNK_CELLS) << top,
                   chunks = ((1u << (2 * (top + 1))) - 1) / 3;
    Image errors(gpu.device,
                 {.name = "errors", .format = VK_FORMAT_R32_SFLOAT, .size = glm::uvec2(1u << top), .mips = top + 1});
    std::vector<std::vector<std::byte>> levels;
    for (uint32_t i = 0; i <= top; ++i) {
        const auto bytes = std::as_bytes(std::span(map.level(int(i))));
        levels.emplace_back(bytes.begin(), bytes.end());
    }
    gpu.upload(errors, levels);
    Image bounds(gpu.device, {.name = "bounds",
                              .format = VK_FORMAT_R32G32_SFLOAT,
                              .size = glm::uvec2(cells),
                              .mips = full_mip_count(glm::uvec2(cells))});
    std::vector<std::vector<std::byte>> level_ground;
    for (uint32_t i = 0; i < bounds.desc.mips; ++i)
        level_ground.emplace_back(sizeof(glm::vec2) * (cells >> i) * (cells >> i), std::byte{0});
    gpu.upload(bounds, level_ground);
    const Buffer list(gpu.device, {.name = "chunk list", .bytes = sizeof(Chunk) * chunks});
    Buffer draws;
    Frame frame(gpu);
    frame.begin({4, 4}, 0);
    frame.upload("draws", draws, std::vector<uint32_t>{6 * CHUNK_CELLS * CHUNK_CELLS, 0, 0, 0, 0});
    frame.compute("chunks", {.reads = {list, draws, errors, bounds}, .writes = {list, draws}}, [&](Compute& pass) {
        pass.use(pipeline).set("chunk_list", list).set("chunk_draw", draws);
        pass.set_if_present("land_errors", errors, nearest_clamp);
        pass.set_if_present("land_bounds", bounds, nearest_clamp);
        pass.set_if_present("land_map", LandMap{.corner = glm::vec2(-0.5f * float(cells)),
                                                .spacing_m = 1,
                                                .samples = int(cells) + 1,
                                                .top = trial.top,
                                                .highest_m = 0});
        pass.set_if_present("chunk_view", ChunkView{trial.to_clip, trial.eye, trial.metres_per_m, -1});
        pass.dispatch_threads(glm::uvec2(chunks, 1));
    });
    frame.end();
    const auto command = gpu.read_back(draws), bytes = gpu.read_back(list);
    std::memcpy(&count, command.data() + 4, 4);
    std::set<Key> found;
    for (uint32_t i = 0; i < std::min(count, chunks); ++i) {
        Chunk chunk{};
        std::memcpy(&chunk, bytes.data() + sizeof chunk * i, sizeof chunk);
        twice = !found.insert({chunk.level, chunk.x, chunk.z}).second || twice;
    }
    return found;
}

std::string name_of(const Key& key) {
    return fmt::format("chunk ({}, {}) of level {}", std::get<1>(key), std::get<2>(key), std::get<0>(key));
}

}  // namespace

CHECK_EXERCISE("15.chunk_level", "Drawn is what is not split, if its parent is, and if it is in view; each once.") {
    glm::mat4 all(1.0f);  // everything within the clip volume
    all = glm::mat4(0.0f);
    all[0][0] = 1e-6f;
    all[2][1] = 1e-6f;
    all[3] = {0, 0, 0.5f, 1};
    glm::mat4 quarter = all;  // x from 20 m on alone
    quarter[0][0] = -0.01f;
    quarter[3][0] = 1.2f;
    glm::mat4 one_and_a_half = quarter;  // x from there on, in chunks of the finest level
    one_and_a_half[3][0] = 1 + 0.015f * float(CHUNK_CELLS);
    const ChunkTrial trials[] = {{"no error is too large", 3, {0, 10, 0}, 1e6f, all},
                                 {"no error is small enough", 3, {0, 0, 0}, 1e-9f, all},
                                 {"an eye above the map", 4, {40, 60, -30}, 0.05f, all},
                                 {"an eye beside the map", 4, {900, 20, 100}, 0.02f, all},
                                 {"an eye on the ground", 4, {-100, 0, 90}, 0.1f, all},
                                 {"half of the map in view", 4, {40, 60, -30}, 0.05f, quarter},
                                 {"a view that ends within four chunks", 3, {0, 0, 0}, 1e-9f, one_and_a_half},
                                 {"one chunk is the whole map", 0, {0, 5, 0}, 0.01f, all},
                                 {"an error of the finest level too", 3, {20, 4, -10}, 0.05f, all, 2.0f},
                                 {"one chunk with an error is the whole map", 0, {0, 5, 0}, 0.01f, all, 2.0f},
                                 {"an error that is exactly the limit", 3, {0, 8, 0}, 0.5f, all, 0.0f, 4.0f}};
    Random random(4);
    for (const ChunkTrial& trial : trials) {
        const ChunkMap map(trial, random);
        const std::set<Key> expected = map.drawn();
        uint32_t count = 0;
        bool twice = false;
        const std::set<Key> found = run_chunks(trial, map, count, twice);
        std::string wrong, hint;
        for (const Key& key : found)
            if (wrong.empty() && !expected.contains(key)) {
                wrong = fmt::format("{} is in the list and must not be", name_of(key));
                const auto [level, x, z] = key;
                hint = !map.in_view(x, z, level) ? "It is not in view."
                       : map.split(x, z, level)  ? "It is split: its four are drawn instead of it."
                                                 : "Its parent is fine enough and is drawn instead of it.";
            }
        for (const Key& key : expected)
            if (wrong.empty() && !found.contains(key)) {
                wrong = fmt::format("{} is not in the list of {}", name_of(key), found.size());
                hint = std::get<0>(key) == 0           ? "Level 0 is the finest: it is never split."
                       : std::get<0>(key) == trial.top ? "The one at the top has no parent."
                       : trial.error > 0               ? "A chunk is split if its error is greater than the limit."
                                                       : "It is not split, its parent is, and it is in view.";
            }
        if (wrong.empty() && twice) {
            wrong = "a chunk is in the list twice";
            hint = "Each thread appends its own chunk, once.";
        }
        if (wrong.empty() && count != expected.size()) {
            wrong = fmt::format("instance_count is {}, expected {}", count, expected.size());
            hint =
                "The place in the list is what atomicAdd returns: two threads that count by themselves overwrite each "
                "other.";
        }
        check.expect(wrong.empty(), fmt::format("{}: {}", trial.what, wrong), hint);
        if (check.failed) return;
    }
}
