// Cached results are remade when one of their inputs differs, and only then.
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "catch.h"
#include "common/base/made.h"

using namespace lightwalk;

namespace {

struct Plain {  // of GLSL's: no ==
    float radius_m;
    int count;
};

}  // namespace

TEST_CASE("what was never made has to be made, and then stays") {
    Made<int, std::string> made;
    CHECK_FALSE(bool(made));
    CHECK(made.from(1, "a"));
    CHECK(bool(made));
    CHECK_FALSE(made.from(1, "a"));
    CHECK_FALSE(made.from(1, "a"));
}

TEST_CASE("each input counts, and going back to an earlier one counts as a change") {
    Made<int, float, std::string> made;
    REQUIRE(made.from(1, 2.0f, "a"));
    CHECK(made.from(3, 2.0f, "a"));
    CHECK(made.from(3, 2.5f, "a"));
    CHECK(made.from(3, 2.5f, "b"));
    CHECK(made.from(1, 2.0f, "a"));
    CHECK_FALSE(made.from(1, 2.0f, "a"));
}

TEST_CASE("texts that are the same when they are joined are different inputs") {
    Made<std::string, std::string> made;
    REQUIRE(made.from("1 2", "3"));
    CHECK(made.from("1", "2 3"));
}

TEST_CASE("numbers that print alike are different inputs") {
    Made<float> made;
    REQUIRE(made.from(0.1f));
    CHECK(made.from(std::nextafter(0.1f, 1.0f)));
}

TEST_CASE("what is forgotten is made again from the same inputs") {
    Made<int> made;
    REQUIRE(made.from(1));
    made.forget();
    CHECK_FALSE(bool(made));
    CHECK(made.from(1));
}

TEST_CASE("structs without == are compared by their bytes, vectors by their elements, pointers by what they keep") {
    Made<Plain> plain;
    REQUIRE(plain.from({1.0f, 2}));
    CHECK_FALSE(plain.from({1.0f, 2}));
    CHECK(plain.from({1.0f, 3}));
    CHECK(plain.inputs().count == 3);

    Made<std::vector<int>> list;
    REQUIRE(list.from({1, 2}));
    CHECK_FALSE(list.from({1, 2}));
    CHECK(list.from({2, 1}));

    Made<std::shared_ptr<int>> shared;
    const auto kept = std::make_shared<int>(1);
    REQUIRE(shared.from(kept));
    CHECK_FALSE(shared.from(kept));
    CHECK(kept.use_count() == 2);  // so that nothing else gets its address
    CHECK(shared.from(std::make_shared<int>(1)));
}
