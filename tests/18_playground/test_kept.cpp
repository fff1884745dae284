// Protection against loss: autosaves after a crash, files that an export would overwrite, a drag under a changed
// view, repeated clicks, and pictures of the scene before.
#include <GLFW/glfw3.h>

#include <chrono>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "18_playground/commands.h"
#include "18_playground/gltf.h"
#include "common/app/read_picture.h"
#include "driven_editor.h"

using namespace lightwalk;
namespace fs = std::filesystem;

namespace {

// As after a crash: beside the scene, and newer.
fs::path leave(const Driven& editor, const std::string& text) {
    const fs::path left = editor.window.editor.store.autosave_file();
    write_file(left, text);
    fs::last_write_time(left, fs::file_time_type::clock::now() + std::chrono::seconds(5));
    return left;
}

}  // namespace

TEST_CASE("what a crash has left is restored without files that are gone: objects keep their places and children") {
    Driven editor;
    leave(editor, R"({"environment": "gone.hdr", "objects": [
        {"name": "gone", "model": "gone.obj", "position": [3, 0, 0]},
        {"name": "left", "parent": "gone", "model": "models/cube.obj", "material": {"maps": {"diffuse": "gone.png"}}}]})");
    REQUIRE(editor.window.editor.store.has_recovery());
    editor.window.editor.recover(editor.window);
    editor.draw();
    CHECK(editor.window.take_notice() == "restored without files that are gone: gone.obj, gone.png, gone.hdr");
    CHECK(world_of(editor.document(), editor.named("left"))[3].x == 3.0f);
    CHECK(editor.document().at(editor.named("gone")).object()->model.empty());
    CHECK(editor.window.scene.items.size() == 1);
    CHECK(editor.window.editor.store.has_unsaved(editor.document()));
}

TEST_CASE("what a crash has left and cannot be read or shown is kept, and the scene is as it was, saved") {
    Driven editor;
    const auto picture = editor.picture();
    const std::string before = state_of(editor.document());
    write_file(editor.folder.path / "bad.obj", "v 0 0 0\nf 1 2 3\n");
    const std::string shows_bad = R"({"objects": [{"model": ")" + (editor.folder.path / "bad.obj").string() + R"("}]})";
    int kept = 0;
    for (const std::string& text : {std::string("{\"objects\": ["), std::string("[]"), shows_bad}) {
        const fs::path left = leave(editor, text);
        editor.window.editor.recover(editor.window);
        CHECK(editor.picture() == picture);
        CHECK(state_of(editor.document()) == before);
        CHECK_FALSE(editor.window.editor.store.has_unsaved(editor.document()));
        CHECK_FALSE(fs::exists(left));
        const std::string name = left.filename().string() + "." + std::to_string(++kept);
        CHECK(read_file(editor.folder.path / name) == text);
        CHECK(editor.window.take_notice().find("kept as " + name) != std::string::npos);
    }
}

TEST_CASE(
    "exported: beside the scene, called like it, as it is after all keys of the frame; other files are asked for") {
    Driven editor;
    const fs::path file = editor.folder.path / "scene.gltf";
    const auto names = [&] {
        const auto json = nlohmann::json::parse(read_file(file));
        std::map<std::string, size_t> vertices;  // by object
        for (const auto& node : json["nodes"])
            if (node.contains("children")) {
                const auto& mesh = json["meshes"][json["nodes"][int(node["children"][0])]["mesh"].get<size_t>()];
                const size_t positions = mesh["primitives"][0]["attributes"]["POSITION"];
                vertices[node["name"]] = json["accessors"][positions]["count"];
            }
        return vertices;
    };
    editor.window.editor.add_model("models/plane.obj", {});
    editor.draw();
    editor.key(GLFW_KEY_E, GLFW_MOD_CONTROL);
    CHECK(editor.window.take_notice() == "exported " + file.string() + "; left out: light from all sides");
    const auto first = names();
    REQUIRE(first.size() == 3);
    CHECK(first.at("plane") != first.at("left"));
    editor.window.editor.selection.set({editor.named("left")});
    editor.window.on_key({GLFW_KEY_DELETE, 0});  // both within a frame
    editor.key(GLFW_KEY_E, GLFW_MOD_CONTROL);
    const auto second = names();
    CHECK(second.size() == 2);
    CHECK(second.at("plane") == first.at("plane"));

    // Another start of the editor knows nothing of this file.
    Driven later;
    const fs::path theirs = later.folder.path / "scene.gltf";
    write_file(theirs, "{}");
    later.key(GLFW_KEY_E, GLFW_MOD_CONTROL);
    CHECK(read_file(theirs) == "{}");
    CHECK(later.window.on_key({GLFW_KEY_F, 0}));  // a question is open
    CHECK_THROWS_AS(export_gltf(later.document(), later.window.scene, later.folder.path / "no" / "x.gltf"), InputError);
}

TEST_CASE("nothing is exported over a model that the scene shows") {
    Driven editor;
    const fs::path file = editor.folder.path / "own.gltf";
    export_gltf(editor.document(), editor.window.scene, file);
    const std::string before = read_file(file);
    editor.window.editor.add_model(file, {});
    editor.draw();
    CHECK_THROWS_AS(export_gltf(editor.document(), editor.window.scene, file), InputError);
    CHECK(read_file(file) == before);
}

TEST_CASE("a drag stays where it is when the window gets another size, and a reload keeps it as a step") {
    Driven editor;
    editor.begin_drag("left");
    const float before = editor.x_of("left");
    editor.live.draw(editor.frame, {{240, 90}, 0, 0, {}});
    editor.window.on_mouse({.cursor = editor.cursor, .left = true}, editor.cursor, true);
    CHECK(std::fabs(editor.x_of("left") - before) < 1e-5f);
    editor.live.reload();
    editor.draw();
    CHECK(std::fabs(editor.x_of("left") - before) < 1e-5f);
    CHECK_FALSE(editor.window.editor.drag);
    CHECK(editor.document().done() == 1);
}

TEST_CASE("a click on a light that is selected keeps it; a Shift click takes it out; F shows what is hidden") {
    Driven editor;
    const EntryId light = add_light(editor.document(), {.kind = Light::Kind::point, .position = {0, 0.2f, 1}});
    editor.draw();
    const glm::vec2 at = *on_screen(editor.window.view_now, {0, 0.2f, 1});
    const auto click = [&](bool shift) {
        for (const bool down : {false, true, false}) {
            editor.window.on_mouse({.cursor = at, .left = down, .shift = shift}, at, true);
            editor.draw();
        }
        editor.draw();  // the frame that would find the file
        editor.window.on_mouse({.cursor = at}, at, true);
    };
    for (int i = 0; i < 2; ++i) {
        click(false);
        CHECK(editor.window.editor.selection.ids == std::vector<EntryId>{light});
    }
    click(true);
    CHECK(editor.window.editor.selection.ids.empty());

    place(editor.document(), editor.named("right"), {{2, 5, 0}, {}, glm::vec3(1)});
    set_hidden(editor.document(), {editor.named("right")}, true);
    editor.window.editor.selection.set({editor.named("right")});
    editor.draw();
    editor.key(GLFW_KEY_F);
    CHECK(glm::length(editor.window.camera.target - glm::vec3(2, 5, 0)) < 1e-4f);
}

TEST_CASE("what is renamed is in sight, whatever is searched for") {
    Driven editor;
    Editor& inner = editor.window.editor;
    const auto shows = [&](const std::string& name) {
        const auto& rows = inner.tree.rows(editor.document());
        return std::any_of(rows.begin(), rows.end(), [&](const TreeRow& row) { return row.id == editor.named(name); });
    };
    inner.tree.search("left");
    inner.selection.set({editor.named("left")});
    editor.key(GLFW_KEY_R, GLFW_MOD_CONTROL);
    CHECK_FALSE(shows("right"));
    inner.selection.set({editor.named("right")});
    editor.key(GLFW_KEY_R, GLFW_MOD_CONTROL);
    CHECK(shows("right"));
}

namespace {

const char* const cubes =
    R"({"camera": {"position": [0, 0.5, 4], "target": [0, 0, 0]}, "ambient": [0.3, 0.3, 0.3], "knobs": {"mlaa.method": "taa"},
    "objects": [{"name": "left", "model": "models/cube.obj"}, {"name": "right", "model": "models/cube.obj", "position": [2, 0, 0]}]})";
const char* const ball =
    R"({"camera": {"position": [0, 0.5, 4], "target": [0, 0, 0]}, "ambient": [0.5, 0.4, 0.2], "knobs": {"mlaa.method": "taa"},
    "objects": [{"name": "ball", "model": "models/sphere.obj", "material": {"diffuse": [0.1, 0.8, 0.2]}}]})";

struct WithTaa : Driven {
    WithTaa() : Driven(cubes) { REQUIRE(window.antialias.method.is("taa")); }
    /// One frame that goes on from those before it.
    std::vector<glm::vec3> on() {
        live.draw(frame, {.size = {80, 60}, .crop = {}, .gathered = 0});
        REQUIRE(live.frame_error.empty());
        return read_linear(gpu, frame.linear()).pixels;
    }
};

}  // namespace

TEST_CASE("a scene that is opened or restored shows nothing of the one before it", "[18.taa]") {
    for (const bool opens : {true, false}) {
        WithTaa editor;
        std::vector<glm::vec3> last;
        for (int i = 0; i < 5; ++i) last = editor.on();
        if (opens) {
            write_file(editor.folder.path / "another.json", ball);
            editor.window.opens = editor.folder.path / "another.json";
        } else {
            leave(editor, ball);
            editor.window.editor.recover(editor.window);
        }
        const int number = editor.frame.gathered;
        const auto after = editor.on();
        editor.window.forget_history();
        editor.frame.gathered = number;
        INFO((opens ? "opened" : "restored"));
        CHECK(after != last);
        CHECK(after == editor.on());
    }
}

TEST_CASE("the surroundings' shadow on the ground is that of what is there, when things and surroundings come and go",
          "[18.ground_shadow]") {
    const auto scene = [](const std::string& objects) {
        return R"({"camera": {"position": [1, 3, 5], "target": [1, 0, 0]}, "environment": "environments/studio.hdr",
            "knobs": {"backdrop.ground": "projected", "backdrop.shadow.directions": 16, "backdrop.shadow.resolution": 32},
            "objects": [)" +
               objects + "]}";
    };
    const auto loaded = [&](const std::string& objects) { return Driven(scene(objects).c_str()).picture(); };
    const std::string left = R"({"name": "left", "model": "models/cube.obj", "position": [0, 0.5, 0]})";
    const std::string right = R"({"name": "right", "model": "models/cube.obj", "position": [2, 0.5, 0]})";
    Driven editor(scene(left + ", " + right).c_str());
    const auto both = editor.picture();
    remove(editor.document(), {editor.named("right")});
    const auto one = editor.picture();
    CHECK(one == loaded(left));
    remove(editor.document(), {editor.named("left")});
    const auto none = editor.picture();
    CHECK(none == loaded(""));
    CHECK((both != one && one != none));
    while (editor.document().done() > 0) editor.window.editor.undo(editor.window);
    editor.window.editor.selection.clear();
    CHECK(editor.picture() == both);
    editor.document().begin("surroundings");
    SceneSettings& settings = *editor.document().edit(root_entry).settings();
    settings.environment.image = "environments/interior.hdr";
    settings.environment.where = "environment";
    editor.document().commit();
    const auto inside = editor.picture();
    CHECK(inside == Driven(editor.window.editor.store.text(editor.document()).c_str()).picture());
}
