// Derived tables are made again when an input differs, and only then.
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "catch.h"
#include "common/app/module.h"
#include "common/base/epoch.h"
#include "common/base/exercise.h"
#include "module_fixture.h"

using namespace lightwalk;

TEST_CASE("each input counts, and an earlier one that returns is a change") {
    Fingerprint made;
    CHECK_FALSE(made.is_current(1, 2.0f, std::string("a")));
    CHECK_FALSE(made.is_current(3, 2.0f, std::string("a")));
    CHECK_FALSE(made.is_current(3, 2.5f, std::string("a")));
    CHECK_FALSE(made.is_current(3, 2.5f, std::string("b")));
    CHECK_FALSE(made.is_current(1, 2.0f, std::string("a")));
    CHECK(made.is_current(1, 2.0f, std::string("a")));
}

TEST_CASE("a forgotten table is made again from the same inputs") {
    Fingerprint made;
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

TEST_CASE("a toggle that is set back gives the epoch from before, an edit never does") {
    Exercises::use("solution");
    const uint64_t before = Exercises::epoch();
    Exercises::set("02.lambert", false);
    const uint64_t toggled = Exercises::epoch();
    CHECK(toggled != before);
    Exercises::set("02.lambert", true);
    CHECK(Exercises::epoch() == before);
    Exercises::shaders_were_edited();
    const uint64_t edited = Exercises::epoch();
    CHECK(edited != before);
    Exercises::set("02.lambert", false);
    CHECK(Exercises::epoch() != toggled);
    Exercises::set("02.lambert", true);
    CHECK(Exercises::epoch() == edited);
}

TEST_CASE("a module's epoch follows its knobs, those of its submodules, and toggles, whichever changed last") {
    struct Inner : Module {
        using Module::Module;
        Knob<float> width{*this, "width", 1.0f, {0.0f, 2.0f}, "width"};
    };
    struct Outer : Module {
        using Module::Module;
        Knob<int> count{*this, "count", 1, {0, 9}, "count"};
        Choice kind{*this, "kind", {"a", "b"}, "a", "kind"};
        Inner inner{*this, "inner"};
    };
    NoChapter chapter;
    Outer module{chapter, "outer"};
    Exercises::use("solution");
    const uint64_t before = module.epoch();
    std::vector<uint64_t> all{before};
    module.count.set("2");
    all.push_back(module.epoch());
    module.kind.set("b");
    all.push_back(module.epoch());
    module.inner.width.set("0.5");
    all.push_back(module.epoch());
    Exercises::set("02.lambert", false);
    all.push_back(module.epoch());
    module.count.set("3");
    all.push_back(module.epoch());
    Exercises::set("02.lambert", true);
    all.push_back(module.epoch());
    std::sort(all.begin(), all.end());
    CHECK(std::adjacent_find(all.begin(), all.end()) == all.end());
    module.count.set("1");
    module.kind.set("a");
    module.inner.width.set("1");
    CHECK(module.epoch() == before);
}
