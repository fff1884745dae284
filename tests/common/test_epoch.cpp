// Derived tables are made again when an input differs, and only then.
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "catch.h"
#include "common/base/epoch.h"

using namespace lightwalk;

TEST_CASE("epochs rise") {
    const uint64_t before = Epoch::next();
    CHECK(Epoch::next() > before);
}

TEST_CASE("a table that was never made has to be made, and then stays") {
    Made made;
    CHECK_FALSE(bool(made));
    CHECK_FALSE(made.is_current(1, std::string("a")));
    CHECK(bool(made));
    CHECK(made.is_current(1, std::string("a")));
    CHECK(made.is_current(1, std::string("a")));
}

TEST_CASE("each input counts, and an earlier one that returns is a change") {
    Made made;
    CHECK_FALSE(made.is_current(1, 2.0f, std::string("a")));
    CHECK_FALSE(made.is_current(3, 2.0f, std::string("a")));
    CHECK_FALSE(made.is_current(3, 2.5f, std::string("a")));
    CHECK_FALSE(made.is_current(3, 2.5f, std::string("b")));
    CHECK_FALSE(made.is_current(1, 2.0f, std::string("a")));
    CHECK(made.is_current(1, 2.0f, std::string("a")));
}

TEST_CASE("a forgotten table is made again from the same inputs") {
    Made made;
    CHECK_FALSE(made.is_current(1));
    made.forget();
    CHECK_FALSE(bool(made));
    CHECK_FALSE(made.is_current(1));
}

TEST_CASE("inputs that read alike side by side are different") {
    using Text = std::string;
    CHECK(hash_of(Text("1 2"), Text("3")) != hash_of(Text("1"), Text("2 3")));
    CHECK(hash_of(Text("ab"), Text()) != hash_of(Text(), Text("ab")));
    CHECK(hash_of(Text("a")) != hash_of(Text("a\0", 2)));
    CHECK(hash_of(std::vector<int>{1, 2}, std::vector<int>{}) != hash_of(std::vector<int>{1}, std::vector<int>{2}));
    CHECK(hash_of(std::vector<int>{1, 2}) != hash_of(std::vector<int>{2, 1}));
    CHECK(hash_of(0.1f) != hash_of(std::nextafter(0.1f, 1.0f)));
    CHECK(hash_of(std::optional<int>{}) != hash_of(std::optional<int>{0}));
    CHECK(hash_of(std::pair(1, 2)) != hash_of(std::pair(2, 1)));
}

TEST_CASE("hashes of a million neighbouring inputs differ") {
    std::vector<uint64_t> all;
    for (int i = 0; i < 1000; ++i)
        for (int j = 0; j < 1000; ++j) all.push_back(hash_of(static_cast<float>(i), j));
    std::sort(all.begin(), all.end());
    CHECK(std::adjacent_find(all.begin(), all.end()) == all.end());
}
