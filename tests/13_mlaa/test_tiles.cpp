// Tiles of a workgroup against one pixel at a time: equal to the bit, on sizes that fill no tile.
#include <fmt/core.h>

#include "mlaa_fixture.h"

using namespace lightwalk;

namespace {

constexpr glm::uvec2 sizes[] = {{1, 1}, {2, 40}, {3, 257}, {33, 34}, {1279, 719}};

float random(int x, int y, uint32_t salt) {
    uint32_t n = (uint32_t(x) * 73856093u) ^ (uint32_t(y) * 19349663u) ^ (salt * 83492791u);
    n = (n ^ n >> 13) * 0x5bd1e995u;
    // Half floats hold it to the bit. Of odd 512ths no two have roots that differ by exactly 1/16 or an eighth: at such a tie
    // rounding, which is the device's, would decide whether there is contrast.
    return (float((n ^ n >> 15) & 255) + 0.5f) / 256.0f;
}

// Blocks of several sizes, slanted edges, single pixels, and a part in which nothing happens.
glm::vec3 mixture(int x, int y) {
    if (x / 160 % 3 == 1 && y / 96 % 2 == 1) return glm::vec3(0.25f);
    const int kind = (x / 64 + y / 64) % 4;
    if (kind == 0) return {random(x / 5, y / 3, 1), random(x / 3, y / 7, 2), random(x / 9, y / 9, 3)};
    if (kind == 1) return glm::vec3(random(x / 40, (y + x / 6) / 9, 4));
    if (kind == 2) return glm::vec3(random(x, y, 5) < 0.02f ? 1.0f : 0.125f);
    return glm::vec3(random((x + y) / 21, (x - y + 4096) / 13, 6));
}

// T. Lottes, "FXAA", 2009, as lesson 13 states it, for one pixel of a picture on the processor.
struct ByHand {
    const std::vector<uint64_t>& texels;
    glm::ivec2 size;
    int search;

    glm::vec3 light(glm::ivec2 p) const {
        p = glm::clamp(p, glm::ivec2(0), size - 1);
        return glm::vec3(glm::unpackHalf4x16(texels[size_t(p.y * size.x + p.x)]));
    }
    float luma(glm::ivec2 p) const { return std::sqrt(glm::dot(light(p), glm::vec3(0.2126f, 0.7152f, 0.0722f))); }

    std::pair<int, float> end(glm::ivec2 p, glm::ivec2 side, glm::ivec2 along, float mean, float enough) const {
        float change = 0;
        for (int i = 1; i <= search; ++i) {
            change = 0.5f * (luma(p + i * along) + luma(p + i * along + side)) - mean;
            if (std::abs(change) >= enough) return {i, change};
        }
        return {search, change};
    }

    glm::vec3 mixed(glm::ivec2 p) const {
        float l[3][3];
        for (int y = 0; y < 3; ++y)
            for (int x = 0; x < 3; ++x) l[y][x] = luma(p + glm::ivec2(x - 1, y - 1));
        const float m = l[1][1], n = l[0][1], s = l[2][1], w = l[1][0], e = l[1][2];
        const float most = std::max({n, s, w, e, m}), range = most - std::min({n, s, w, e, m});
        if (range < std::max(1.0f / 16, most / 8)) return light(p);
        const auto bend = [](float a, float b, float c) { return std::abs(a + c - 2 * b); };
        const float rows = bend(l[0][0], w, l[2][0]) + 2 * bend(n, m, s) + bend(l[0][2], e, l[2][2]);
        const float columns = bend(l[0][0], n, l[0][2]) + 2 * bend(w, m, e) + bend(l[2][0], s, l[2][2]);
        const bool flat = rows >= 0.99999f * columns;
        const float before = flat ? n : w, behind = flat ? s : e;
        const int towards = std::abs(before - m) >= std::abs(behind - m) ? -1 : 1;
        const glm::ivec2 side = flat ? glm::ivec2(0, towards) : glm::ivec2(towards, 0), along(flat, !flat);
        const float other = towards < 0 ? before : behind, mean = 0.5f * (m + other);
        const float enough = 0.25f * std::abs(other - m);
        const auto [back, left_back] = end(p, side, -along, mean, enough);
        const auto [ahead, left_ahead] = end(p, side, along, mean, enough);
        const float left = back < ahead ? left_back : left_ahead;
        const bool turns = left * (m - mean) < 0 && std::abs(left) >= enough;
        const float by_end = turns ? 0.5f - (float(std::min(back, ahead)) - 0.5f) / float(back + ahead - 1) : 0.0f;
        const float around = (2 * (n + s + w + e) + l[0][0] + l[0][2] + l[2][0] + l[2][2]) / 12;
        const float lone = glm::smoothstep(0.0f, 1.0f, std::min(std::abs(around - m) / range, 1.0f));
        return glm::mix(light(p), light(p + side), std::max(by_end, 0.5f * lone * lone));
    }
};

// Which edges smaa_like keeps, one pixel at a time: right 1, below 2.
const char* const kept_edges = R"(
#include "13_mlaa/lab_distance.glsl"
#include "13_mlaa/picture.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
layout(scalar) uniform MlaaBlock { float threshold; } mlaa;
layout(r32ui) writeonly uniform uimage2D edges;
float between(ivec2 a, ivec2 b) { return lab_distance(to_lab(light_at(a)), to_lab(light_at(b))); }
bool kept(ivec2 p, ivec2 along) {
    ivec2 q = p + along, across = along.yx;
    float strongest = max(max(between(p, p - along), between(q, q + along)),
                          max(max(between(p, p + across), between(p, p - across)), max(between(q, q + across), between(q, q - across))));
    return between(p, q) > mlaa.threshold && 2.0 * between(p, q) >= strongest;
}
void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, imageSize(edges)))) return;
    imageStore(edges, pixel, uvec4(uint(kept(pixel, ivec2(1, 0))) | uint(kept(pixel, ivec2(0, 1))) << 1));
})";

}  // namespace

TEST_CASE_METHOD(OnMlaa, "fxaa_like mixes each pixel as it would be mixed alone", "[13.fxaa_tiles]") {
    for (const glm::uvec2 size : sizes)
        for (const int search : {16, 5}) {
            if (search != 16 && size.x > 1000) continue;
            antialias.search.value = search;
            filter("fxaa_like", size, mixture);
            const ByHand by_hand{before, glm::ivec2(size), search};
            const std::vector<uint64_t> now = after();
            size_t wrong = 0, changed = 0;
            for (int y = 0; y < int(size.y); ++y)
                for (int x = 0; x < int(size.x); ++x) {
                    const uint64_t texel = now[size_t(y) * size.x + size_t(x)];
                    const glm::vec3 right = by_hand.mixed({x, y}), found(glm::unpackHalf4x16(texel));
                    for (int c = 0; c < 3; ++c) wrong += std::abs(found[c] - right[c]) > right[c] / 1024 + 1e-6f;
                    changed += texel != before[size_t(y) * size.x + size_t(x)];
                }
            INFO(size.x << "x" << size.y << ", search " << search << ": " << changed << " changed");
            CHECK(wrong == 0);
            CHECK((size.x < 30 || changed > size.x * size.y / 20));
        }
}

TEST_CASE_METHOD(OnMlaa, "smaa_like keeps the edges that each pixel alone would keep, by every way to read them",
                 "[13.edge_tiles]") {
    const Pipeline alone = compute({.shader = "test/kept_edges.comp", .macros = {}, .source = kept_edges});
    Image original, edges;
    for (const glm::uvec2 size : sizes) {
        filter("smaa_like", size, mixture);
        const std::vector<uint64_t> by_words = after();
        const auto rows = numbers<uint32_t>(gpu.read_back(antialias.edge_rows()));
        edges.ensure(gpu.device, {.name = "kept edges", .format = VK_FORMAT_R32_UINT, .size = size});
        filter_frame(original, size, before, [&] {
            frame.compute("alone", {.reads = {original}, .writes = {edges}, .with = {antialias}}, [&](Compute& pass) {
                pass.use(alone).set("picture", original, nearest_clamp).set("edges", edges).dispatch_threads(size);
            });
        });
        const auto expected = numbers<uint32_t>(gpu.read_back(edges));
        size_t wrong = 0, count = 0;
        for (size_t y = 0; y < size.y; ++y)
            for (size_t x = 0; x < size.x; ++x) {
                const uint32_t word = rows[y * ((size.x + 15) / 16) + x / 16] >> x % 16;
                const uint32_t found = (word >> 16 & 1) | (word & 1) << 1, right = expected[y * size.x + x];
                wrong += found != right;
                count += right != 0;
            }
        INFO(size.x << "x" << size.y << ": " << count << " with edges");
        CHECK(wrong == 0);
        CHECK((size.x < 30 || count > size.x * size.y / 50));

        antialias.reads.set("two");
        filter("smaa_like", size, mixture);
        CHECK((after() == by_words));
        antialias.reads.set("words");
    }
}
