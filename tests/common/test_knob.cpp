// Knobs: one declaration gives option, macro, uniform and description.
#include <nlohmann/json.hpp>

#include "catch.h"
#include "common/app/knob.h"
#include "common/base/error.h"

using namespace lightwalk;

TEST_CASE("a number keeps to its range and kind") {
    Knob<float> size{"size", 2.0f, {0.5f, 8.0f}, "how large", "m"};
    size.set("0.5");
    CHECK(size == 0.5f);
    for (const char* wrong : {"0.4", "8.1", "", "x", "1x", "nan", "inf", "1,2", "-1"}) {
        INFO(wrong);
        CHECK_THROWS_AS(size.set(wrong), InputError);
        CHECK(size == 0.5f);
    }
    CHECK_THROWS_WITH(size.set("9"), "size=9: expected a number from 0.5 to 8 m");
    size.reset();
    CHECK(size == 2.0f);
    CHECK(size.describe()["range"][1] == 8.0);

    Knob<int> count{"count", 4, {1, 64}, "how many"};
    CHECK_THROWS_AS(count.set("1.5"), InputError);
    count.set("64");
    CHECK(count.text() == "64");

    Knob<glm::vec3> color{"color", glm::vec3(1.0f), {glm::vec3(0.0f), glm::vec3(1.0f)}, "a colour"};
    color.set("0.25,0.5,1");
    CHECK(color.numbers() == std::vector<float>{0.25f, 0.5f, 1.0f});
    CHECK(color.text() == "0.25,0.5,1");
    for (const char* wrong : {"1,1", "1,1,1,1", "1,1,2", "1;1;1"}) CHECK_THROWS_AS(color.set(wrong), InputError);
}

TEST_CASE("a choice becomes macros that a shader compares") {
    Choice method{"method", {"none", "hard"}, "hard", "which"};
    const auto macros = method.macros();
    CHECK(macros[0] == std::pair<std::string, std::string>{"METHOD", "1"});
    CHECK(macros[1] == std::pair<std::string, std::string>{"METHOD_NONE", "0"});
    CHECK_THROWS_WITH(method.set("soft"), "method=soft: expected one of none, hard");
    method.set("none");
    CHECK(method.is("none"));
    CHECK(method.numbers().empty());
}

TEST_CASE("a switch is compiled in") {
    Knob<bool> fog{"fog", false, "mist"};
    CHECK(fog.macros()[0].second == "0");
    fog.set("on");
    CHECK(fog.macros()[0].second == "1");
    CHECK_THROWS_AS(fog.set("maybe"), InputError);
}

TEST_CASE("knobs declared while a chapter is made belong to it, and an unknown name lists them") {
    KnobList list;
    knobs_under_construction() = &list;
    Knob<float> a{"a", 0, {0, 1}, "first"};
    Choice b{"b", {"x"}, "x", "second"};
    knobs_under_construction() = nullptr;
    REQUIRE(list.size() == 2);
    CHECK(&find_knob(list, "b") == &b);
    CHECK_THROWS_WITH(find_knob(list, "c"), "unknown knob 'c'; this chapter has: a, b");
}
