// Thousands of entries and of steps, and culling.
#include <fmt/core.h>

#include "common/app/read_picture.h"
#include "driven_editor.h"

using namespace lightwalk;

// By counting first: a list of n that is gone through for each of n entries passes n² children, on any machine.
namespace {
void do_to_many(uint64_t count) {
    Document document;
    document.most_bytes = uint64_t(1) << 30;
    const std::vector<EntryId> lights = scatter(document, {{-5, 0, -5}, {5, 2, 5}}, int(count), 1);
    document.begin("objects");
    std::vector<EntryId> objects;
    for (uint64_t i = 1; i <= count; ++i)
        objects.push_back(document.add(root_entry, {.what = named(fmt::format("crate {}", i))}));
    document.commit();
    Selection selection;
    const auto costs = [&](const char* what, const auto& command) {
        const uint64_t passed = document.children_passed();
        const double start = processor_ms();
        command();
        const double ms = processor_ms() - start;
        fmt::print("{}: {:.0f} ms, {} children passed\n", what, ms, document.children_passed() - passed);
        CHECK(document.children_passed() - passed <= 6 * count);
        CHECK(ms < slower * double(count) / 50.0);
    };
    const std::vector<EntryId> first = document.at(root_entry).children;
    const std::string before = state_of(document);
    for (const auto& [kind, ids] : {std::pair("lights", lights), std::pair("objects", objects)}) {
        INFO(kind);
        std::vector<EntryId> copies;
        costs("duplicate", [&] { copies = duplicate(document, ids); });
        REQUIRE(copies.size() == count);
        const std::vector<EntryId>& children = document.at(root_entry).children;
        const auto place = std::find(children.begin(), children.end(), ids[777]);
        CHECK(*(place + 1) == copies[777]);
        const std::string doubled = state_of(document);
        costs("delete", [&] { remove(document, copies); });
        CHECK(document.at(root_entry).children == first);
        costs("undo", [&] { document.undo(); });
        CHECK((state_of(document) == doubled));
        costs("undo", [&] { document.undo(); });
        CHECK((state_of(document) == before));
        costs("redo", [&] {
            document.redo();
            document.redo();
        });
        CHECK(document.at(root_entry).children == first);
    }
    CHECK(document.at(document.at(root_entry).children.back()).name() == fmt::format("crate {}", count));
    const EntryId folder = document.at(root_entry).children.front();
    costs("group", [&] { REQUIRE(group(document, objects, "folder") != folder); });
    costs("undo", [&] { document.undo(); });
    CHECK((state_of(document) == before));
}
}  // namespace

TEST_CASE("what is done to 20,000 entries at once goes through lists of children a few times, not once for each") {
    do_to_many(20000);
}

// Lesson 18's figures; it takes ten times as long.
TEST_CASE("what is done to 100,000 entries at once", "[.][18.all_at_once]") { do_to_many(100000); }

TEST_CASE("the list of steps goes back over 5,000 of them and forward again at once, and says how many") {
    Driven editor;
    Document& document = editor.document();
    const EntryId left = editor.named("left");
    for (int i = 1; i <= 5000; ++i) {
        document.begin("move " + std::to_string(i));
        document.edit(left).object()->position.x = float(i);
        document.commit();
    }
    const double start = processor_ms();
    editor.window.editor.go_to(editor.window, 17);
    CHECK(editor.x_of("left") == 17.0f);
    CHECK(editor.window.take_notice() == "undone: 4983 steps");
    editor.window.editor.go_to(editor.window, 4000);
    CHECK(editor.x_of("left") == 4000.0f);
    CHECK(editor.window.take_notice() == "done again: 3983 steps");
    CHECK(processor_ms() - start < 200.0 * slower);
    editor.window.editor.go_to(editor.window, 4000);
    CHECK(editor.window.take_notice().empty());
    editor.window.editor.go_to(editor.window, 0);
    CHECK(editor.x_of("left") == 0.0f);
    CHECK_FALSE(editor.window.editor.undo(editor.window));
    editor.window.editor.go_to(editor.window, 9999);
    CHECK(editor.x_of("left") == 5000.0f);
}

namespace {

/// A wall, and behind it rows of cubes; the camera looks at the wall, past which one row is seen.
std::string cubes_behind_a_wall(int count) {
    std::string scene = R"({"camera": {"position": [0, 1, 6], "target": [0, 0.5, 0]}, "ambient": [0.4, 0.4, 0.4],
        "lights": [{"type": "directional", "direction": [-0.4, -0.8, -0.5], "shadow": true}],
        "objects": [{"name": "wall", "model": "models/cube.obj", "position": [-1, 2, 2], "scale": [4, 6, 0.2]})";
    for (int i = 0; i < count; ++i)
        scene += fmt::format(R"(,
        {{"name": "c{}", "model": "models/cube.obj", "position": [{}, 0, {}], "scale": 0.3, "material": {{"diffuse": [{}, 0.5, 0.2]}}}})",
                             i, 0.5 * (i % 40) - 12, -0.5 * (i / 40), i % 2 ? 0.8 : 0.2);
    return scene + "]}";
}

std::vector<glm::vec3> picture(Driven& editor, glm::uvec2 pixels) {
    editor.live.draw(editor.frame, {.size = pixels, .crop = {}});
    REQUIRE(editor.live.frame_error.empty());
    return read_linear(editor.gpu, editor.frame.linear()).pixels;
}

}  // namespace

TEST_CASE("few objects are all drawn; of many those that are seen, also while the camera and an object move",
          "[18.culling]") {
    Driven few(cubes_behind_a_wall(60).c_str());
    CHECK_FALSE(few.window.objects.culling.culls());

    Driven editor(cubes_behind_a_wall(4000).c_str());
    Culling& culling = editor.window.objects.culling;
    REQUIRE(culling.culls());
    for (int i = 0; i < 8; ++i) {
        const glm::uvec2 pixels = i < 5 ? glm::uvec2(81, 45) : glm::uvec2(64, 61);
        if (i > 0) editor.window.camera.position += glm::vec3(i == 4 ? 9.0f : 0.3f, 0.1f, i == 6 ? -5.0f : 0.0f);
        if (i == 3) place(editor.document(), editor.named("wall"), {{3, 2, 2}, {}, glm::vec3(4, 6, 0.2f)});
        const auto culled = picture(editor, pixels);
        const size_t drawn = culling.drawn(), tested = culling.tested();
        culling.method.set("none");
        const auto all = picture(editor, pixels);
        culling.method.set("occlusion");
        INFO("frame " << i);
        CHECK(culled == all);
        CHECK(tested == 4001);
        CHECK(drawn < tested);
        if (i == 2) CHECK(2 * drawn < tested);  // behind the wall
    }
}
