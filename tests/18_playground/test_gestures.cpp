// Actions during others: keys, arriving files, saving and reloading in the middle of a drag.
#include <GLFW/glfw3.h>

#include <thread>

#include "common/study/need.h"
#include "driven_editor.h"

using namespace lightwalk;

TEST_CASE("a key in the middle of a drag ends it where it is; the mouse that is still held moves nothing any more") {
    const struct {
        int key, mods;
        size_t steps;
    } keys[] = {{GLFW_KEY_Y, GLFW_MOD_CONTROL, 0},  // first: nothing has been undone
                {GLFW_KEY_DELETE, 0, 2},
                {GLFW_KEY_D, GLFW_MOD_CONTROL, 2},
                {GLFW_KEY_G, GLFW_MOD_CONTROL, 2},
                {GLFW_KEY_ESCAPE, 0, 0},
                {GLFW_KEY_ENTER, 0, 1},
                {GLFW_KEY_Z, GLFW_MOD_CONTROL, 0}};
    Driven editor;
    for (const auto& key : keys) {
        INFO("key " << key.key);
        const std::string before = state_of(editor.document());
        editor.begin_drag("left");
        editor.key(key.key, key.mods);
        const std::string after = state_of(editor.document());
        CHECK(editor.mouse(editor.cursor + glm::vec2(20, 3), true));  // nor does it orbit
        CHECK(state_of(editor.document()) == after);
        CHECK_FALSE(editor.window.editor.drag);
        editor.mouse(editor.cursor, false);
        CHECK_FALSE(editor.mouse(editor.cursor, false));
        CHECK(editor.document().done() == key.steps);
        while (editor.document().undo()) {}
        CHECK(state_of(editor.document()) == before);
    }
}

TEST_CASE("a file that arrives in the middle of a drag waits until the mouse is released") {
    Driven editor;
    editor.begin_drag("left");
    editor.window.on_drop({find_asset("models/plane.obj")});
    for (int i = 0; i < 150; ++i) {
        editor.mouse(editor.cursor + glm::vec2(i % 2 ? 1 : -1, 0), true);
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    CHECK(editor.window.editor.drag);
    CHECK(editor.document().size() == 3);
    editor.mouse(editor.cursor, false);
    for (int i = 0; i < 2000 && editor.document().size() == 3; ++i) {
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
        editor.draw();
    }
    CHECK(editor.document().size() == 4);
    CHECK(editor.document().done() == 2);
}

TEST_CASE("what was cancelled is not waited for, and does not come with the next file") {
    Driven editor;
    std::string grid;
    for (int i = 0; i < 400000; ++i) grid += fmt::format("v {} {} 1\nv {} 0 0\nv 0 1 0\nf -1 -2 -3\n", i, i % 7, i);
    write_file(editor.folder.path / "large.obj", grid);
    editor.window.on_drop({editor.folder.path / "large.obj"});
    editor.draw();
    editor.key(GLFW_KEY_ESCAPE);
    editor.window.on_drop({find_asset("models/plane.obj")});
    for (int i = 0; i < 5000 && editor.document().size() == 3; ++i) {
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
        editor.draw();
    }
    CHECK(editor.named("plane") != no_entry);
    CHECK(editor.named("large") == no_entry);
    CHECK(editor.window.scene.models().size() == 2);
}

TEST_CASE("saved in the middle of a drag: the file has what the document has, whatever the mouse does then") {
    Driven editor;
    editor.begin_drag("right");
    editor.window.on_save();
    editor.mouse(editor.cursor + glm::vec2(15, 0), true);
    editor.key(GLFW_KEY_ESCAPE);
    editor.mouse(editor.cursor, false);
    const SceneStore& store = editor.window.editor.store;
    CHECK_FALSE(store.has_unsaved(editor.document()));
    CHECK(read_scene(store.path).objects.at(1).position.x == editor.x_of("right"));
    CHECK(editor.x_of("right") != 2);
}

TEST_CASE("knobs that are turned in the middle of a drag become a step after it") {
    Driven editor;
    editor.begin_drag("left");
    editor.window.bloom.method.set("paired");
    for (int i = 0; i < 2; ++i) editor.mouse(editor.cursor + glm::vec2(5, 0), true);  // the second one finds it open
    CHECK(editor.window.editor.drag);
    editor.mouse(editor.cursor, false);
    CHECK(editor.document().settings().knobs.at("bloom.method") == "paired");
    CHECK(editor.document().done() == 2);
}

TEST_CASE("loaded again by F5 or a toggle: what is being edited stays, saved or not, whichever file it is") {
    Driven editor;
    const std::filesystem::path other = editor.folder.path / "other.json";
    write_file(other, R"({"camera": {"position": [0, 0.5, 4]}, "background": [0.1, 0.2, 0.3],
        "objects": [{"name": "ball", "model": "models/sphere.obj"}]})");
    editor.window.opens = other;
    editor.draw();
    REQUIRE(editor.named("ball") != no_entry);
    const auto picture = editor.picture();
    editor.live.reload();  // the window knows the file that it was started with
    CHECK(editor.picture() == picture);
    CHECK(editor.window.editor.store.path == other);
    rename(editor.document(), editor.named("ball"), "not saved");
    editor.live.reload();
    CHECK(editor.picture() == picture);
    REQUIRE(editor.named("not saved") != no_entry);
    // Somebody else has written it. It is read once nothing is lost by that.
    write_file(other, R"({"camera": {"position": [0, 0.5, 4]}, "objects": [{"name": "theirs"}]})");
    editor.live.reload();
    CHECK(editor.named("not saved") != no_entry);
    CHECK(editor.named("theirs") == no_entry);
    CHECK(editor.window.editor.store.changed_on_disk());
    editor.document().undo();
    CHECK(editor.named("ball") != no_entry);
    editor.live.reload();
    editor.draw();
    CHECK(editor.named("theirs") != no_entry);
    CHECK(editor.document().size() == 1);
    CHECK(editor.window.scene.items.empty());
}

TEST_CASE("F5 keeps steps and selection where neither the file nor what it includes has changed") {
    Driven editor;
    EditorWindow& window = editor.window;
    const std::filesystem::path part = editor.folder.path / "part.json";
    write_file(part, R"({"objects": [{"name": "part"}]})");
    editor.write(R"({"include": ["part.json"], "camera": {"position": [0, 0.5, 4]},
        "objects": [{"name": "own", "model": "models/cube.obj"}]})");
    editor.live.reload();
    editor.draw();
    REQUIRE(editor.named("part") != no_entry);
    rename(editor.document(), editor.named("own"), "mine");
    window.editor.store.save(editor.document());
    window.editor.selection.set({editor.named("mine")});
    const auto picture = editor.picture();
    editor.live.reload();
    CHECK(editor.picture() == picture);
    CHECK(window.editor.selection.ids == std::vector{editor.named("mine")});
    CHECK(editor.document().undo());
    CHECK(editor.named("own") != no_entry);
    CHECK(editor.document().redo());
    write_file(part, R"({"objects": [{"name": "other part"}]})");
    editor.live.reload();
    editor.draw();
    CHECK(editor.named("other part") != no_entry);
    CHECK(editor.named("part") == no_entry);
    CHECK(editor.named("mine") != no_entry);
}

TEST_CASE("other surroundings and other ambient light show at once, as where the scene is opened with them") {
    Driven editor;
    for (const char* image : {"environments/interior.hdr", ""}) {
        editor.document().begin("surroundings");
        SceneSettings& settings = *editor.document().edit(root_entry).settings();
        settings.environment.image = image;
        settings.environment.where = "environment";
        settings.ambient = glm::vec3(0.6f, 0.1f, 0.2f);
        editor.document().commit();
        const auto picture = editor.picture();
        Driven opened(editor.window.editor.store.text(editor.document()).c_str());
        CHECK(picture == opened.picture());
    }
}

TEST_CASE("Ctrl+G groups about the middle of what is drawn, and the picture stays; of lights alone there is no group") {
    Driven driven;
    Editor& editor = driven.window.editor;
    const EntryId left = driven.named("left"), right = driven.named("right");
    place(driven.document(), right, {{2, 0, 0}, {}, glm::vec3(3)});  // from 0.5 to 3.5
    editor.selection.clear();
    const auto before = driven.picture();
    editor.selection.set({left, right});
    driven.key(GLFW_KEY_G, GLFW_MOD_CONTROL);
    const EntryId made = editor.selection.active();
    CHECK(driven.document().at(left).parent == made);
    const auto gizmo = gizmo_place(driven.document(), editor.selection, driven.window.view_now, Tool::rotate, false);
    REQUIRE(gizmo);
    CHECK(gizmo->pivot == glm::vec3(1.5f, 0, 0));
    editor.selection.clear();
    CHECK((driven.picture() == before));
    const EntryId light = add_light(driven.document(), {.kind = Light::Kind::point});
    editor.selection.set({light});
    driven.key(GLFW_KEY_G, GLFW_MOD_CONTROL);
    CHECK(editor.selection.active() == light);
    CHECK(driven.window.take_notice() == "no object is selected that could be grouped");
}

TEST_CASE("lights are picked where they are seen, the nearest one; what is hidden or locked never is") {
    Driven driven;
    Editor& editor = driven.window.editor;
    const EntryId first = add_light(driven.document(), {.kind = Light::Kind::point}),
                  second = add_light(driven.document(), {.kind = Light::Kind::point, .position = {0.05f, 0, 0}});
    const View view = driven.window.view_now;
    const glm::vec2 at = *on_screen(view, glm::vec3(0.0f));
    CHECK(editor.light_at(view, at) == first);
    CHECK(editor.light_at(view, *on_screen(view, {0.05f, 0, 0})) == second);
    editor.selection.set({first});
    CHECK(editor.selected_bounds(driven.window.scene).lower == glm::vec3(-0.5f));
    set_hidden(driven.document(), {first}, true);
    CHECK(editor.light_at(view, at) == second);
    set_locked(driven.document(), {second, driven.named("left")}, true);
    CHECK_FALSE(editor.light_at(view, at).has_value());
    driven.draw();
    editor.select_item(driven.window.scene, 0, false);
    CHECK(editor.selection.ids.empty());
    editor.select_item(driven.window.scene, 1, false);
    CHECK(editor.selection.active() == driven.named("right"));
    const EntryId plane = editor.add_model("models/plane.obj", {});  // as any clone of the course finds it
    CHECK(driven.document().at(plane).object()->model == "models/plane.obj");
}

TEST_CASE("what auto tries while it measures is no step; what it chooses is one") {
    Driven editor;
    Choice& bloom = editor.window.bloom.method;
    bloom.set("paired");
    editor.draw();
    REQUIRE(editor.document().done() == 1);
    editor.key(GLFW_KEY_1);  // another gesture, as by the click on the menu
    CHECK(choose_method(editor.window, editor.gpu, bloom, 0.9, {{64, 48}, 0, 0, {}})
              .find("is the fastest within 0.9; 9 were measured") != std::string::npos);
    CHECK(editor.document().done() == 1);
    const std::string chosen = bloom.text();
    CHECK(chosen != "exact");
    editor.draw();
    CHECK(editor.document().done() == (chosen == "paired" ? 1 : 2));
    editor.key(GLFW_KEY_Z, GLFW_MOD_CONTROL);
    CHECK(bloom.is(chosen == "paired" ? "none" : "paired"));
}
