// Ranges of one heap (docs/minimal/00_ranges.h): against a heap whose entries are marked one by one.
#include <fmt/format.h>

#include <algorithm>
#include <random>
#include <vector>

#include "catch.h"
#include "docs/minimal/00_ranges.h"

namespace {

struct Range {
    uint32_t first, count;
};

// First `count` unmarked entries in a row.
std::optional<uint32_t> first_fit(const std::vector<bool>& taken, uint32_t count) {
    uint32_t run = 0;
    for (uint32_t i = 0; i < taken.size(); ++i) {
        run = taken[i] ? 0 : run + 1;
        if (run == count) return i + 1 - count;
    }
    return std::nullopt;
}

}  // namespace

TEST_CASE("00: ranges are where a heap marked entry by entry has room, and none is lost", "[00.ranges]") {
    std::mt19937 random(1);
    for (const uint32_t size : {1u, 7u, 64u, 2048u}) {
        Ranges ranges(size);
        std::vector<bool> taken(size);
        std::vector<Range> live;
        for (int step = 0; step < 4000; ++step) {
            if (random() % 2 == 0) {
                const auto count = static_cast<uint32_t>(1 + random() % std::min(size, 32u));
                const std::optional<uint32_t> expected = first_fit(taken, count), first = ranges.allocate(count);
                REQUIRE(first == expected);
                if (!first) continue;
                live.push_back({*first, count});
                std::fill_n(taken.begin() + *first, count, true);
            } else if (!live.empty()) {
                std::swap(live[random() % live.size()], live.back());
                ranges.free(live.back().first, live.back().count);
                std::fill_n(taken.begin() + live.back().first, live.back().count, false);
                live.pop_back();
            }
            uint32_t free = 0, end = 0;
            for (const auto& [first, count] : ranges.free_ranges()) {
                REQUIRE((free == 0 || first > end));  // neighbours are one range
                free += count;
                end = first + count;
            }
            REQUIRE(free == static_cast<uint32_t>(std::count(taken.begin(), taken.end(), false)));
        }
        for (const Range& range : live) ranges.free(range.first, range.count);
        CHECK(ranges.free_ranges() == std::map<uint32_t, uint32_t>{{0, size}});
    }
}

TEST_CASE("00: a heap that merges stays small, and one that does not grows", "[00.pieces]") {
    // Entries that a heap needs while models of 1 to 32 textures come and random ones go, at most 1,536 textures at a time.
    const auto entries_needed = [](bool merge, int loads) {
        std::mt19937 random(1);
        Ranges ranges(1 << 20, merge);
        std::vector<Range> live;
        uint32_t used = 0, needed = 0;
        for (int load = 0; load < loads; ++load) {
            const auto count = static_cast<uint32_t>(1 + random() % 32);
            for (; used + count > 1536; live.pop_back()) {
                std::swap(live[random() % live.size()], live.back());
                ranges.free(live.back().first, live.back().count);
                used -= live.back().count;
            }
            live.push_back({ranges.allocate(count).value(), count});
            used += count;
            needed = std::max(needed, live.back().first + count);
        }
        fmt::print("{} merging, {} models: {} entries\n", merge ? "with" : "without", loads, needed);
        return needed;
    };
    CHECK(entries_needed(true, 1000) == 1957);
    CHECK(entries_needed(true, 10000) == 1957);
    CHECK(entries_needed(true, 100000) == 2014);
    CHECK(entries_needed(false, 1000) == 3534);
    CHECK(entries_needed(false, 10000) == 5534);
    CHECK(entries_needed(false, 100000) == 7484);
}
