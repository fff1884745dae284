// Checks of 13.lab_edges: whole workgroups on pixels that are known, in several orders.
#include <fmt/core.h>

#include <cmath>
#include <glm/glm.hpp>

#include "common/check/barriers.h"
#include "common/check/check.h"
#include "common/check/workgroup.h"

using namespace lightwalk;

namespace {

const std::string before = R"(
int corner_x() { return 16 * int(case_index) - 16; }
int corner_y() { return 16 - 16 * int(case_index); }
vec3 lab_at(ivec2 pixel) {
    ivec2 place = clamp(pixel - ivec2(corner_x(), corner_y()) + 3, ivec2(0), ivec2(21));
    check_count(uint(place.y * 22 + place.x));
    uint n = uint(pixel.x + 64) * 73856093u ^ uint(pixel.y + 64) * 19349663u;
    n = ((n ^ n >> 13) + given[0]) * 0x5bd1e995u;
    n ^= n >> 15;
    return vec3(n & 63u, n >> 8 & 31u, n >> 16 & 31u);
}
)";
const char* const call = R"(
for (int slot = int(local); slot < 18 * 18; slot += 256) keep_lab(slot, vec3(-777.0));
barrier();
uint edges = lab_edges(ivec2(corner_x(), corner_y()), 24.6);
put(0u, edges);
)";

glm::dvec3 lab_at(int x, int y) {
    uint32_t n = (uint32_t(x + 64) * 73856093u) ^ (uint32_t(y + 64) * 19349663u);
    n = ((n ^ n >> 13) + check_seed()) * 0x5bd1e995u;
    n ^= n >> 15;
    return {double(n & 63u), double(n >> 8 & 31u), double(n >> 16 & 31u)};
}

uint32_t edges_at(int x, int y) {
    const auto differs = [&](int u, int v) { return glm::distance(lab_at(x, y), lab_at(u, v)) > 24.6; };
    return uint32_t(differs(x + 1, y)) + 2u * differs(x, y + 1) + 4u * differs(x - 1, y) + 8u * differs(x, y - 1);
}

std::string in_words(uint32_t edges) {
    std::string words;
    const char* const sides[] = {"right", "below", "left", "above"};
    for (uint32_t i = 0; i < 4; ++i)
        if (edges >> i & 1) words += fmt::format("{}{}", words.empty() ? "" : " + ", sides[i]);
    return fmt::format("{} ({})", edges, words.empty() ? "none" : words);
}

}  // namespace

CHECK_EXERCISE(
    "13.lab_edges",
    "A loop in which each thread stores every 256th of the 18 by 18 pixels, barrier(), then four distances.") {
    const WorkgroupResults results(check_device(), {.include = "13_mlaa/lab_edges.glsl",
                                                    .before = before,
                                                    .call = call,
                                                    .given = {check_seed()},
                                                    .cases = 3,
                                                    .puts = 1,
                                                    .counts = 484});
    for (uint32_t which = 0; which < 3; ++which)
        for (uint32_t order = 0; order < workgroup_orders; ++order) {
            const int corner_x = 16 * int(which) - 16, corner_y = 16 - 16 * int(which);
            for (uint32_t i = 0; i < workgroup_size; ++i) {
                const int x = corner_x + int(i % 16), y = corner_y + int(i / 16);
                const uint32_t got = results.at(which, order, i, 0), right = edges_at(x, y);
                check.expect(
                    got == right,
                    fmt::format("lab_edges(corner = ({}, {})): thread {}, for pixel ({}, {}), gave {}, expected {}",
                                corner_x, corner_y, i, x, y, in_words(got), in_words(right)),
                    order > 0 ? "The threads ran in another order here: every slot must be filled, and barrier() must "
                                "stand between storing and reading (memoryBarrierShared() does not wait)."
                              : "Slot (y + 1) * 18 + x + 1 holds the pixel (x, y) of the square.");
                if (got != right) return;
            }
            for (uint32_t place = 0; place < 484; ++place) {
                const uint32_t times = results.count(which, order, place);
                const int x = int(place % 22) - 3, y = int(place / 22) - 3;
                const bool wanted = x >= -1 && y >= -1 && x <= 16 && y <= 16;
                check.expect(
                    times <= 1,
                    fmt::format("lab_at() was asked {} times for the pixel ({}, {}) of the square, expected once",
                                times, x, y),
                    "one thread asks and keeps; all others read what is kept");
                check.expect(wanted || times == 0, fmt::format("lab_at() was asked for ({}, {}) from the square's "
                                                               "corner, which no pixel of the square touches",
                                                               x, y));
                if (times > 1 || (!wanted && times > 0)) return;
            }
        }
    const std::string wrong = results.barriers();
    check.expect(wrong.empty(), "lab_edges: " + wrong, barrier_hint);
}
