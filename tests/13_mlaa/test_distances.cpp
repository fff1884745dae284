// Lengths of edges: recursive doubling against counting, and behaviour beyond the reach.
#include <fmt/core.h>

#include "mlaa_fixture.h"

using namespace lightwalk;

namespace {

float noise(int x, int y) {
    uint32_t n = (uint32_t(x) * 73856093u) ^ (uint32_t(y) * 19349663u);
    n = (n ^ n >> 13) * 0x5bd1e995u;
    return float((n ^ n >> 15) & 255) / 256.0f;  // half floats hold it to the bit
}

// Lines of all lengths: rows of black and white that break off by lot.
float broken_rows(int x, int y) { return (y / 2) % 2 == 0 && noise(x / 7, y / 2) > 0.12f ? 1.0f : 0.0f; }

bool differs(const std::function<float(int, int)>& light, int x, int y, int dx, int dy, glm::ivec2 size) {
    const int u = x + dx, v = y + dy;
    return x >= 0 && y >= 0 && u < size.x && v < size.y && light(x, y) != light(u, v);
}

// For how many pixels from (x, y) on the edge below (or on the right) goes on in a direction.
uint32_t counted(const std::function<float(int, int)>& light, int x, int y, bool below, int step, glm::ivec2 size,
                 uint32_t reach) {
    uint32_t length = 0;
    while (length < reach && differs(light, x, y, below ? 0 : 1, below ? 1 : 0, size)) {
        ++length;
        (below ? x : y) += step;
    }
    return length;
}

}  // namespace

TEST_CASE_METHOD(OnMlaa, "distances are those that counting gives, for every reach and number of reads") {
    const glm::ivec2 size(300, 24);
    for (const auto& [reach, reads] : {std::pair{2, "two"},
                                       {3, "two"},
                                       {7, "two"},
                                       {64, "two"},
                                       {255, "two"},
                                       {5, "four"},
                                       {16, "four"},
                                       {255, "four"},
                                       {2, "words"},
                                       {17, "words"},
                                       {100, "words"},
                                       {255, "words"}})
        for (const bool upright : {false, true}) {
            antialias.reach.value = reach;
            antialias.reads.set(reads);
            const auto light = [&](int x, int y) { return upright ? broken_rows(y, x) : broken_rows(x, y); };
            const glm::ivec2 turned = upright ? glm::ivec2(size.y, size.x) : size;
            filter("mlaa", glm::uvec2(turned), light);
            const auto words = lengths(turned);
            size_t wrong = 0;
            uint32_t longest = 0;
            for (int y = 0; y < turned.y; ++y)
                for (int x = 0; x < turned.x; ++x) {
                    const uint32_t word = words[size_t(y * turned.x + x)];
                    for (uint32_t d = 0; d < 4; ++d) {
                        const uint32_t right =
                            counted(light, x, y, d < 2, d % 2 == 0 ? -1 : 1, turned, uint32_t(reach));
                        wrong += (word >> 8 * d & 255) != right;
                        longest = std::max(longest, right);
                    }
                }
            INFO("reach " << reach << ", " << reads << " reads, upright " << upright);
            CHECK(wrong == 0);
            CHECK(longest >= uint32_t(std::min(reach, 100)));
        }
}

TEST_CASE("passes: two reads reach 2^k beyond the pixel in k, four reads 255 in four", "[13.passes]") {
    struct : Module {
    } owner;
    Mlaa antialias{owner, "mlaa"};
    antialias.reads.set("two");
    for (const auto& [reach, passes] : {std::pair{2, 0}, {3, 1}, {5, 2}, {65, 6}, {66, 7}, {255, 8}}) {
        antialias.reach.value = reach;
        CHECK(antialias.passes() == passes);
    }
    antialias.reads.set("four");
    for (const auto& [reach, passes] : {std::pair{2, 0}, {5, 1}, {6, 2}, {65, 3}, {255, 4}}) {
        antialias.reach.value = reach;
        CHECK(antialias.passes() == passes);
    }
}

TEST_CASE_METHOD(OnMlaa, "two reads, four and words give one picture to the bit, a reach of all of it what 255 gives",
                 "[13.reads_agree]") {
    for (const double angle : {3.0, 41.0}) {
        const Line line{.angle_deg = angle, .point = {47.4, 31.7}};
        const auto light = [&](int x, int y) { return noise(x / 5, y / 3) < 0.06f ? 0.5f : line.sample(x, y); };
        for (const std::string method : {"mlaa", "smaa_like"}) {
            std::map<int, std::vector<uint64_t>> of;
            for (const int reach : {6, 96, 255})
                for (const std::string reads : {"two", "four", "words"}) {
                    antialias.reach.value = reach;
                    antialias.reads.set(reads);
                    filter(method, {96, 64}, light);
                    if (reads == "two") of[reach] = after();
                    INFO(method << " at " << angle << ", reach " << reach << ", " << reads);
                    CHECK((after() == of[reach]));
                }
            CHECK((of[96] == of[255]));
            if (angle < 10) CHECK((of[6] != of[255]));
        }
    }
}

TEST_CASE_METHOD(OnMlaa, "runs longer than the reach: the worst share is wrong by as much as counting by hand says",
                 "[figures]") {
    for (const int run : {64, 256})
        for (const int reach : {4, 7, 16, 32, 64, 128, 255}) {
            double by_hand = 0;
            for (int p = 0; p < run; ++p)
                by_hand = std::max(by_hand, std::abs(truth::capped_area(p, run, reach) - truth::area(p, run)));
            // A staircase of such runs: the turn is at x = 0 of each.
            antialias.reach.value = reach;
            const int width = 3 * run;
            const ImageRgb found =
                filter("mlaa", {uint32_t(width), 12}, [&](int x, int y) { return y >= 8 - x / run ? 1.0f : 0.0f; });
            double worst = 0, by_formula = 0;
            for (int p = 0; p < run; ++p) {  // the run in the middle; its line lies below row 6
                const double above = double(found.at(run + p, 6).g), below = 1 - double(found.at(run + p, 7).g);
                const int from_end = run - 1 - p;
                worst = std::max(
                    {worst, std::abs(above - truth::area(from_end, run)), std::abs(below - truth::area(p, run))});
                by_formula = std::max({by_formula, std::abs(above - truth::capped_area(from_end, run, reach)),
                                       std::abs(below - truth::capped_area(p, run, reach))});
            }
            fmt::print("run {:3} reach {:3}: worst share off by {:.3f}\n", run, reach, by_hand);
            INFO("run " << run << " reach " << reach);
            CHECK(worst == Approx(by_hand).margin(1e-3));
            CHECK(by_formula < 1e-3);
            if (reach >= run) CHECK(by_hand == 0);
        }
}

TEST_CASE_METHOD(OnMlaa, "smaa_like drops an edge less than half as strong as one beside it, and keeps it elsewhere",
                 "[13.smaa_weak]") {
    const auto light = [](int x, int y) {  // black, white, grey; and without the black below
        return x < 10 && y < 16 ? 0.0f : x < 12 ? 0.8f : 0.5f;
    };
    for (const bool upright : {true, false}) {
        const auto turned = [&](int x, int y) { return upright ? light(x, y) : light(y, x); };
        std::map<std::string, std::vector<uint32_t>> words;
        for (const std::string method : {"mlaa", "smaa_like"}) {
            filter(method, {32, 32}, turned);
            words[method] = lengths({32, 32});
        }
        const auto has = [&](const std::string& method, int x, int y) {
            const uint32_t word = words[method][size_t(upright ? y * 32 + x : x * 32 + y)];
            return (upright ? word >> 16 : word & 0xffff) != 0;
        };
        for (const int y : {3, 25}) CHECK(has("mlaa", 11, y));
        CHECK(has("smaa_like", 9, 3));    // the strong one
        CHECK(has("smaa_like", 11, 25));  // alone
        CHECK(has("smaa_like", 11, 3));   // two pixels away from the strong one
    }
    const auto close = [&](int x, int) { return x < 10 ? 0.0f : x < 11 ? 0.8f : 0.5f; };
    for (const auto& [method, seen] : {std::pair{"mlaa", true}, {"smaa_like", false}}) {
        filter(method, {32, 8}, close);
        const auto words = lengths({32, 8});
        CHECK((words[4 * 32 + 9] >> 16) != 0);
        CHECK(((words[4 * 32 + 10] >> 16) != 0) == seen);
    }
}

TEST_CASE_METHOD(OnMlaa, "a picture turned or mirrored is mixed as the picture was", "[figures]") {
    constexpr int side = 48;
    // A triangle and a disc: their outlines are lines and staircases with many kinds of ends.
    const auto shapes = [](glm::ivec2 p) {
        const bool triangle = p.y > 4 && p.x > 3 && p.x - p.y < 8.4 && 0.83 * p.x + p.y < 43.7;
        return triangle || glm::distance(glm::dvec2(p), {34.2, 33.6}) < 9.3 ? 1.0f : 0.0f;
    };
    using Turn = glm::ivec2 (*)(glm::ivec2);
    constexpr std::pair<const char*, Turn> turns[] = {
        {"by 180 degrees", [](glm::ivec2 p) { return side - 1 - p; }},
        {"left to right", [](glm::ivec2 p) { return glm::ivec2(side - 1 - p.x, p.y); }},
        {"upside down", [](glm::ivec2 p) { return glm::ivec2(p.x, side - 1 - p.y); }},
        {"about the diagonal", [](glm::ivec2 p) { return glm::ivec2(p.y, p.x); }}};
    for (const std::string& method : filters) {
        const ImageRgb straight = filter(method, {side, side}, [&](int x, int y) { return shapes({x, y}); });
        for (const auto& [name, turn] : turns) {
            const ImageRgb found = filter(method, {side, side}, [&, turn = turn](int x, int y) {
                return shapes(turn({x, y}));
            });
            float worst = 0;
            int differ = 0;
            for (int y = 0; y < side; ++y)
                for (int x = 0; x < side; ++x) {
                    const glm::ivec2 from = turn({x, y});
                    const float difference = std::abs(found.at(x, y).g - straight.at(from.x, from.y).g);
                    worst = std::max(worst, difference);
                    differ += difference > 0.002f;
                }
            fmt::print("{}, {}: {} pixels differ, by {:.3f} at most\n", method, name, differ, worst);
            INFO(method << " " << name);
            if (method == "mlaa") CHECK(worst == 0.0f);
            if (method == "smaa_like") CHECK(differ <= (std::string(name) == "about the diagonal" ? 20 : 0));
            if (method == "fxaa_like") CHECK(differ <= 3);  // where both sides are as strong
        }
    }
}
