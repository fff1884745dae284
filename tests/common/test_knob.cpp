// Knobs: one declaration gives option, macro, uniform and description.
#include <cstring>
#include <nlohmann/json.hpp>

#include "catch.h"
#include "common/app/module.h"
#include "common/base/error.h"

using namespace lightwalk;

namespace {

struct Root : Module {};

}  // namespace

TEST_CASE("a number keeps to its range and kind") {
    Root root;
    Knob<float> size{root, "size", 2.0f, {0.5f, 8.0f}, "how large", "m"};
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

    Knob<int> count{root, "count", 4, {1, 64}, "how many"};
    CHECK_THROWS_AS(count.set("1.5"), InputError);
    count.set("64");
    CHECK(count.text() == "64");
    CHECK(count.describe()["default"].dump() == "4");
    CHECK(count.describe()["range"].dump() == "[1,64]");

    Knob<glm::vec3> color{root, "color", glm::vec3(1.0f), {glm::vec3(0.0f), glm::vec3(1.0f)}, "a colour"};
    color.set("0.25,0.5,1");
    const KnobBase::Numbers numbers = color.numbers();
    CHECK(std::vector<float>(numbers.begin(), numbers.end()) == std::vector<float>{0.25f, 0.5f, 1.0f});
    CHECK(color.text() == "0.25,0.5,1");
    for (const char* wrong : {"1,1", "1,1,1,1", "1,1,2", "1;1;1"}) CHECK_THROWS_AS(color.set(wrong), InputError);
}

TEST_CASE("a choice becomes macros that a shader compares") {
    Root root;
    Choice method{root, "method", {"none", "hard"}, "hard", "which"};
    Macros macros;
    method.add_macros(macros);
    CHECK(macros.values() ==
          std::map<std::string, std::string>{{"METHOD", "1"}, {"METHOD_HARD", "1"}, {"METHOD_NONE", "0"}});
    CHECK_THROWS_WITH(method.set("soft"), "method=soft: expected one of none, hard");
    method.set("none");
    CHECK(method.is("none"));
    CHECK(method.numbers().count == 0);
}

TEST_CASE("a switch is compiled in") {
    Root root;
    Knob<bool> fog{root, "fog", false, "mist"};
    CHECK(root.macros().values().at("FOG") == "0");
    fog.set("on");
    CHECK(root.macros().values().at("FOG") == "1");
    CHECK_THROWS_AS(fog.set("maybe"), InputError);
}

namespace {

struct Inner : Module {
    using Module::Module;
    Choice filter{*this, "filter", {"hard", "pcf"}, "pcf", "which"};
    Knob<float> bias_m{*this, "bias_m", 0.5f, {0, 1}, "how far"};
};

struct Outer : Module {
    Choice method{*this, "method", {"one", "two"}, "one", "which"};
    Inner sun{*this, "sun", "shadow"}, lamp{*this, "lamp", "shadow"};
    Knob<int> count{*this, "count", 3, {0, 9}, "how many"};
};

}  // namespace

TEST_CASE("a module's name stands before its knobs, and its kind before their macros") {
    Outer outer;
    const KnobList knobs = outer.all_knobs();
    std::string paths;
    for (const KnobBase* knob : knobs) paths += knob->path() + " ";
    CHECK(paths == "method sun.filter sun.bias_m lamp.filter lamp.bias_m count ");
    CHECK(&find_knob(knobs, "lamp.filter") == &outer.lamp.filter);
    CHECK(outer.sun.macros().values().at("SHADOW_FILTER") == "1");
    CHECK(outer.macros().values().count("SHADOW_FILTER") == 0);
    CHECK_THROWS_WITH(outer.lamp.bias_m.set("2"), "lamp.bias_m=2: expected a number from 0 to 1");
}

TEST_CASE("a name alone finds the one knob that has it, or the one that answers to it") {
    Outer outer;
    const KnobList knobs = outer.all_knobs();
    CHECK_THROWS_WITH(find_knob(knobs, "filter"), "knob 'filter' could be sun.filter or lamp.filter");
    outer.lamp.filter.preferred = true;
    CHECK(&find_knob(knobs, "filter") == &outer.lamp.filter);
    CHECK(has_short_name(knobs, outer.lamp.filter));
    CHECK(!has_short_name(knobs, outer.sun.filter));
    CHECK(!has_short_name(knobs, outer.method));
    CHECK_THROWS_WITH(find_knob(knobs, "c"),
                      "unknown knob 'c'; the nearest are count and method; --list knobs lists all");
}

TEST_CASE("a module fills its uniform block and no other") {
    Outer outer;
    outer.lamp.bias_m.set("0.25");
    const Binding block{.name = "shadow",
                        .hash = BindingName("shadow").hash,
                        .layout = 1,
                        .type = VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER,
                        .bytes = 4,
                        .members = {{.name = "bias_m", .type = BlockMember::Type::number}}};
    const auto number_in = [&](const Inner& of) {
        const std::span<const std::byte> bytes = of.block(block);
        float value = 0;
        REQUIRE(bytes.size() == 4);
        std::memcpy(&value, bytes.data(), 4);
        return value;
    };
    CHECK(number_in(outer.lamp) == 0.25f);
    outer.lamp.bias_m.set("0.5");
    CHECK(number_in(outer.lamp) == 0.5f);
    CHECK(outer.block(block).empty());
    Binding unknown = block;
    unknown.layout = 2;
    unknown.members[0].name = "slope";
    CHECK_THROWS_WITH(outer.sun.block(unknown),
                      "the shader's shadow.slope is no knob of the module sun; the nearest is bias_m");
}

TEST_CASE("what a pass is given brings its own modules along; a chapter does not") {
    Outer outer;
    struct Nest : Module {
        using Module::Module;
        Inner inner{*this, "inner"};
    } nest(outer, "nest");
    std::vector<const PassInputs*> all;
    nest.expand(all);
    CHECK(all == std::vector<const PassInputs*>{&nest, &nest.inner});
    all.clear();
    outer.expand(all);
    CHECK(all == std::vector<const PassInputs*>{&outer});
    CHECK(nest.inner.path() == "nest.inner");
}
