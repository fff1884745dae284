// The document: steps, undo and redo, the tree, names, and how long each takes.
#include <cmath>

#include "18_playground/tree.h"
#include "editor_fixture.h"

using namespace lightwalk;

TEST_CASE("10,000 random commands are undone to the start and done again to the end, bit by bit", "[18.commands]") {
    Document document;
    document.most_bytes = uint64_t(1) << 40;
    Random random(18);
    const std::string start = state_of(document);
    std::vector<std::string> states;
    for (int i = 0; i < 10000; ++i) {
        random_command(document, random);
        if (i % 500 == 0) states.push_back(state_of(document));
    }
    const std::string end = state_of(document);
    const size_t steps = document.done();
    CHECK(steps > 2000);
    parse_scene(scene_text(exported(document).scene), "scene.json");
    size_t undone = 0;
    while (document.undo()) ++undone;
    CHECK(state_of(document) == start);
    CHECK(document.size() == 0);
    while (document.redo()) --undone;
    CHECK(undone == 0);
    CHECK(state_of(document) == end);
    fmt::print("{} steps, {} entries at the end, {:.1f} MB\n", steps, document.size(), double(document.bytes()) / 1e6);
}

TEST_CASE("a drag of 100 frames is one step, and so are 100 turns of one dial") {
    Document document;
    const EntryId id = add_object(document, named("a"));
    const size_t steps = document.done();
    for (int i = 1; i <= 100; ++i) place(document, id, {{float(i), 0, 0}, {}, glm::vec3(1)}, 5);
    CHECK(document.done() == steps + 1);
    document.undo();
    CHECK(document.at(id).object()->position == glm::vec3(0));
    document.redo();
    for (int i = 99; i >= 0; --i) place(document, id, {{float(i), 0, 0}, {}, glm::vec3(1)}, 5);
    CHECK(document.done() == steps);  // it is where it was: there is nothing to undo
    place(document, id, {{1, 0, 0}, {}, glm::vec3(1)}, 6);
    place(document, id, {{2, 0, 0}, {}, glm::vec3(1)}, 7);
    CHECK(document.done() == steps + 2);
}

TEST_CASE("steps hold at most so many bytes, and the last one can always be undone") {
    Document document;
    document.most_bytes = 20000;
    const EntryId id = add_object(document, named("a"));
    for (int i = 1; i < 200; ++i) {
        place(document, id, {{float(i), 0, 0}, {}, glm::vec3(1)});
        REQUIRE(document.bytes() <= 20000);
    }
    CHECK(document.done() > 3);
    document.most_bytes = 1;
    place(document, id, {{500, 0, 0}, {}, glm::vec3(1)});
    CHECK(document.done() == 1);
    document.undo();
    CHECK(document.at(id).object()->position.x == 199);
}

TEST_CASE("another parent keeps the place in the world, also at the poles and below uneven scales", "[18.parent]") {
    Document document;
    Random random(4);
    const EntryId parent = add_object(document, named("parent")), child = add_object(document, named("child"));
    double worst = 0;
    for (int i = 0; i < 2000; ++i) {
        const auto angle = [&] { return static_cast<float>(random.uniform(-180, 180)); };
        const float pole = i % 3 == 0 ? 90.0f : i % 3 == 1 ? 89.9999f : angle();
        place(document, parent, {{1, 2, 3}, {angle(), pole, angle()}, glm::vec3(float(random.uniform(0.5, 2)))});
        place(document, child, {{4, 5, 6}, {angle(), i % 2 ? angle() : -90.0f, angle()}, {1, 2, 0.5f}});
        const glm::mat4 before = world_of(document, child);
        CHECK(reparent(document, {child}, i % 2 ? root_entry : parent) == "");
        const glm::mat4 after = world_of(document, child);
        for (int c = 0; c < 4; ++c)
            for (int r = 0; r < 4; ++r) worst = std::max(worst, double(std::fabs(before[c][r] - after[c][r])));
    }
    fmt::print("another parent: {:.2g} m off at most\n", worst);
    CHECK(worst < 1e-4);
    place(document, parent, {{}, {0, 0, 30}, {1, 4, 1}});
    reparent(document, {child}, root_entry);
    place(document, child, {{1, 1, 1}, {0, 0, 20}, glm::vec3(1)});
    CHECK(reparent(document, {child}, parent).find("shear") != std::string::npos);
}

TEST_CASE("cycles, locked things, lights as children and scales of 0 are refused, and nothing has changed") {
    Document document;
    const EntryId a = add_object(document, named("a")), b = add_object(document, named("b"), a),
                  c = add_object(document, named("c"), b), light = add_light(document, {});
    const std::string before = state_of(document);
    CHECK(reparent(document, {a}, c).find("circle") != std::string::npos);
    CHECK(reparent(document, {a}, a).find("circle") != std::string::npos);
    CHECK(reparent(document, {a, c}, b).find("circle") != std::string::npos);
    CHECK(reparent(document, {light}, a) == "a light hangs below no object");
    CHECK(reparent(document, {a}, light) == "only an object can be a parent");
    for (const float scale : {0.0f, 1e-9f, 1e9f, NAN, INFINITY})
        CHECK(place(document, a, {{}, {}, {1, scale, 1}}).find("not possible") != std::string::npos);
    CHECK(place(document, a, {{NAN, 0, 0}, {}, glm::vec3(1)}) != "");
    CHECK(state_of(document) == before);
    set_locked(document, {a}, true);
    CHECK(remove(document, {c}) == "what is selected is locked");
    CHECK(place(document, c, {{1, 0, 0}, {}, glm::vec3(1)}) == "it is locked");
    CHECK(rename(document, b, "x") == "it is locked");
}

TEST_CASE("names: two alike, quotes, line ends and bytes that are no UTF-8 can be saved and are read back") {
    Document document;
    const EntryId a = add_object(document, named("lamp")), b = add_object(document, named("lamp")),
                  screen = add_object(document, named("screen", "models/cube.obj"));
    CHECK(document.at(b).name() == "lamp 2");
    CHECK(rename(document, b, "lamp").find("another object") != std::string::npos);
    CHECK(document.at(b).name() == "lamp 2");
    document.begin("show");
    document.edit(screen).object()->shows = "lamp";
    document.edit(screen).object()->role.object = Role::screen;
    document.commit();
    for (const std::string name :
         {"a \"b\" 'c'", "two\nlines\t", "\xff\xc3(", "\xed\xa0\x80", "ü→漢😀", "\\u0041", "/"}) {
        rename(document, a, name);
        const SceneFile back = parse_scene(scene_text(exported(document).scene), "scene.json");
        CHECK(back.objects[0].name == document.at(a).name());
        CHECK(document.at(screen).object()->shows == document.at(a).name());
    }
    document.undo();
    CHECK(document.at(a).name() == "\\u0041");
}

TEST_CASE("euler angles are those near to what was there, and say the rotation to 1e-4 degrees at the poles too",
          "[18.angles]") {
    Random random(6);
    double worst = 0;
    for (int i = 0; i < 20000; ++i) {
        const double tilt = i % 4 == 0 ? 90 : i % 4 == 1 ? 90 - random.logarithmic(1e-7, 1) : random.uniform(-180, 180);
        const glm::vec3 degrees(random.uniform(-400, 400), tilt, random.uniform(-400, 400));
        const glm::vec3 back = rotation_deg_of(rotation_of(degrees), degrees);
        const glm::dquat a = rotation_of(degrees), b = rotation_of(back);
        worst = std::max(
            worst, glm::degrees(2 * glm::length(glm::dvec3(glm::conjugate(a).w * b.x + glm::conjugate(a).x * b.w +
                                                               glm::conjugate(a).y * b.z - glm::conjugate(a).z * b.y,
                                                           0, 0))));
        if (std::fabs(std::cos(glm::radians(tilt))) > 1e-2) CHECK(glm::length(back - degrees) < 1e-2f);
    }
    fmt::print("angles read back: {:.2g} degrees off at most\n", worst);
    CHECK(worst < 1e-4);
}

TEST_CASE("a tree of 100,000 entries is listed, searched and unfolded without a stutter") {
    Document document;
    document.begin("many");
    std::vector<EntryId> folders;
    for (int i = 0; i < 1000; ++i)
        folders.push_back(document.add(root_entry, {.what = named(fmt::format("folder {}", i))}));
    for (int i = 0; i < 99000; ++i) document.add(folders[size_t(i) % 1000], {.what = named(fmt::format("leaf {}", i))});
    document.commit();
    CHECK(document.size() == 100000);
    Tree tree;
    CHECK(tree.rows(document).size() == 1000);
    for (const EntryId id : folders) tree.unfold(id, true);
    double start = now_ms();
    CHECK(tree.rows(document).size() == 100000);
    const double all = now_ms() - start;
    start = now_ms();
    for (int i = 0; i < 100; ++i) tree.rows(document);
    const double again = (now_ms() - start) / 100;
    tree.search("LEAF 98");
    start = now_ms();
    CHECK(tree.rows(document).size() > 1000);
    const double found = now_ms() - start;
    CHECK(tree.rows(document)[0].depth == 0);
    fmt::print("100,000 rows: {:.1f} ms, unchanged {:.5f} ms, search {:.1f} ms\n", all, again, found);
    CHECK(again < 0.1);
    CHECK(all < 1000);
    tree.search("");
    const EntryId first = tree.rows(document)[3].id, last = tree.rows(document)[9].id;
    CHECK(tree.between(last, first).size() == 7);
}

TEST_CASE("undo of 1,000 moved objects among 10,000 takes less than 5 ms", "[18.undo_time]") {
    Document document;
    document.begin("many");
    std::vector<EntryId> ids;
    for (int i = 0; i < 10000; ++i)
        ids.push_back(document.add(root_entry, {.what = named(fmt::format("object {}", i), "models/cube.obj")}));
    document.commit();
    document.begin("move 1000");
    for (size_t i = 0; i < 1000; ++i) document.edit(ids[10 * i]).object()->position.x = 1;
    document.commit();
    double best = 1e9;
    for (int i = 0; i < 5; ++i) {
        const double start = now_ms();
        document.undo();
        best = std::min(best, now_ms() - start);
        document.redo();
    }
    fmt::print("undo of 1,000 objects: {:.2f} ms\n", best);
    CHECK(best < 5);
}

// The Unicode Standard, 3.9, table 3-7: U+D800 to U+DFFF have no form in UTF-8.
TEST_CASE("names keep the characters on both sides of the surrogates, and no surrogate") {
    const std::string none = "\xef\xbf\xbd", of_three = none + none + none;
    CHECK(clean_name("\xed\x9f\xbf") == "\xed\x9f\xbf");
    CHECK(clean_name("\xed\xa0\x80") == of_three);
    CHECK(clean_name("\xed\xbf\xbf") == of_three);
    CHECK(clean_name("\xee\x80\x80") == "\xee\x80\x80");
    CHECK(clean_name("\xf4\x8f\xbf\xbf") == "\xf4\x8f\xbf\xbf");
    CHECK(clean_name("\xf4\x90\x80\x80") == none + of_three);
    CHECK(clean_name("\xe0\x9f\xbf") == of_three);  // a longer form of a shorter one
}
