// A module's life: order of the chapter's calls, and the changes that reload its scene.
#include <algorithm>
#include <filesystem>

#include "catch.h"
#include "common/app/module.h"
#include "common/base/exercise.h"
#include "common/base/files.h"
#include "common/check/check.h"
#include "common/scene/scene.h"

using namespace lightwalk;

namespace {

std::vector<std::string> prepared;

struct Part : Module {
    using Module::Module;
    bool moves = false;
    std::string key;
    std::vector<std::string> exercises;
    void prepare(Gpu&, Scene&) override { prepared.push_back(path()); }
    bool animated() const override { return moves; }
    std::string load_key() const override { return key; }
    std::vector<std::string> load_exercises() const override { return exercises; }
};

struct Whole : Part {
    using Part::Part;
    Part inner{*this, "inner"}, last{*this, "last"};
};

struct Tree : Module {
    Part first{*this, "first"};
    Whole whole{*this, "whole"};
    void prepare(Gpu&, Scene&) override { prepared.push_back("chapter"); }
    ~Tree() override { Exercises::use("solution"); }
};

constexpr const char* id = "04.parallax_offset";

}  // namespace

TEST_CASE("all modules are prepared, each after those that it owns, and the chapter last") {
    Tree tree;
    Scene scene;
    prepared.clear();
    tree.prepare_all(check_device(), scene);
    CHECK(prepared == std::vector<std::string>{"first", "whole.inner", "whole.last", "whole", "chapter"});
    prepared.clear();
    tree.whole.in_use = [] { return false; };
    tree.prepare_all(check_device(), scene);
    CHECK(prepared == std::vector<std::string>{"first", "chapter"});
}

TEST_CASE("a chapter moves where one of its modules in use does, however deep") {
    Tree tree;
    CHECK_FALSE(tree.any_animated());
    tree.whole.last.moves = true;
    CHECK(tree.any_animated());
    tree.whole.in_use = [] { return false; };
    CHECK_FALSE(tree.any_animated());
}

TEST_CASE("what loading depends on: keys, toggles and whether a module is in use") {
    REQUIRE(Exercises::has_solution(id));
    Tree tree;
    std::vector<std::string> states{tree.load_state()};
    const auto differs = [&] {
        const std::string state = tree.load_state();
        const bool is_new = std::find(states.begin(), states.end(), state) == states.end();
        states.push_back(state);
        return is_new;
    };
    tree.whole.inner.key = "16";
    CHECK(differs());
    Exercises::set(id, false);
    CHECK_FALSE(differs());  // no module runs it while a scene is loaded
    CHECK_FALSE(tree.loads_exercise());
    tree.whole.last.exercises = {id};
    CHECK(differs());
    CHECK(tree.loads_exercise());
    Exercises::set(id, true);
    CHECK(differs());
    CHECK_FALSE(tree.loads_exercise());
    Exercises::set(id, false);
    bool used = false;
    tree.whole.in_use = [&] { return used; };
    CHECK_FALSE(tree.loads_exercise());
    const std::string without = tree.load_state();
    used = true;
    CHECK(tree.load_state() != without);
    CHECK(tree.loads_exercise());
}

TEST_CASE("an exercise in C++ is known by its file: no chapter is linked with these tests") {
    namespace fs = std::filesystem;
    const std::vector<std::string> ids = Exercises::ids();
    for (const auto& chapter : fs::directory_iterator(course_root() / "chapters")) {
        if (!fs::is_directory(chapter.path() / "exercise")) continue;
        for (const auto& file : fs::directory_iterator(chapter.path() / "exercise")) {
            const std::string known =
                chapter.path().filename().string().substr(0, 2) + "." + file.path().stem().string();
            CAPTURE(known);
            CHECK(std::count(ids.begin(), ids.end(), known) == 1);
            CHECK(Exercises::has_solution(known) == fs::exists(chapter.path() / "solution" / file.path().filename()));
        }
    }
}
