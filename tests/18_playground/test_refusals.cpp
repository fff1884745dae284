// The editor's refusals, with a line that says why, and consequences of an edit: knobs, included files, screens.
#include <GLFW/glfw3.h>

#include <limits>

#include "driven_editor.h"

using namespace lightwalk;

TEST_CASE("an entry that a scene file could not hold is refused, and the line says which key and why",
          "[18.refused_entries]") {
    const FileFolder folder;
    write_file(folder.path / "wide.png", "");
    const auto of_light = [&](const auto& set) {
        Entry entry{.what = Light{.kind = Light::Kind::spot}};
        set(*entry.light());
        return cannot_be_saved(entry, folder.path / "scene.json");
    };
    const auto of_scene = [&](const auto& set) {
        Entry entry{.what = SceneSettings{}};
        set(*entry.settings());
        return cannot_be_saved(entry, folder.path / "scene.json");
    };
    const float infinite = std::numeric_limits<float>::infinity(), none = std::numeric_limits<float>::quiet_NaN();
    CHECK(of_light([](Light&) {}) == "");
    CHECK(of_light([&](Light& light) { light.intensity = none; }).starts_with("key 'intensity'"));
    CHECK(of_light([&](Light& light) { light.position.y = infinite; }).starts_with("key 'position'"));
    CHECK(of_light([&](Light& light) { light.position.y = 1e30f; }).starts_with("key 'position'"));
    CHECK(of_light([&](Light& light) { light.inner_rad = 2.0f * light.outer_rad; }).find("inner_deg") != Said::npos);
    CHECK(of_scene([](SceneSettings&) {}) == "");
    CHECK(of_scene([](SceneSettings& scene) { scene.ambient.x = -1.0f; }).starts_with("key 'ambient'"));
    CHECK(of_scene([](SceneSettings& scene) {
              scene.camera.position = {0, 5, 0};
              scene.camera.target = {};
              scene.camera.up = {0, 1, 0};
          }).find("points along the view") != Said::npos);
    CHECK(of_scene([](SceneSettings& scene) { scene.camera.far_m = scene.camera.near_m; }).find("near_m") !=
          Said::npos);
    CHECK(of_scene([](SceneSettings& scene) { scene.environment.image = "wide.png"; }).find(".hdr") != Said::npos);
    // Other entries' contents are not its business: neither a parent's name nor a screen's object.
    Entry object{.what = named("a \"quoted\" name", "models/cube.obj")};
    object.object()->parent = "above";
    CHECK(cannot_be_saved(object, {}) == "");
    object.object()->material.maps["diffuse"] = "textures/none.png";
    CHECK(cannot_be_saved(object, {}).find("none.png") != Said::npos);
}

TEST_CASE("a place that is refused is said by what was typed: position, rotation or scale") {
    Document document;
    const EntryId id = add_object(document, named("a"));
    const size_t steps = document.done();
    const float infinite = std::numeric_limits<float>::infinity();
    CHECK(place(document, id, {{0, 2e9f, 0}, {}, glm::vec3(1)}).find("position of 2e+09") != Said::npos);
    CHECK(place(document, id, {{3, 0, 0}, {0, 0, infinite}, glm::vec3(1)}).find("rotation of inf") != Said::npos);
    CHECK(place(document, id, {{}, {}, {1, 0, 1}}).find("scale of 0") != Said::npos);
    CHECK(document.done() == steps);
}

TEST_CASE("a screen whose object is deleted shows nothing, and the scene can still be saved") {
    Document document;
    const EntryId camera = add_object(document, named("camera"));
    SceneObject screen = named("screen", "models/plane.obj");
    screen.shows = "camera";
    const EntryId id = add_object(document, screen);
    CHECK(remove(document, {camera}) == "");
    CHECK(document.at(id).object()->shows.empty());
    document.undo();
    CHECK(document.at(id).object()->shows == "camera");
}

TEST_CASE("where something of an included file was changed, the file has all of it once, and includes nothing") {
    const FileFolder folder;
    write_file(folder.path / "part.json", R"({"objects": [{"name": "p"}]})");
    write_file(folder.path / "whole.json", R"({"include": ["part.json"], "objects": [{"name": "own"}]})");
    SceneStore store;
    Document document = store.open(folder.path / "whole.json");
    CHECK(store.text(document).find("part.json") != std::string::npos);
    const EntryId included = document.at(root_entry).children.at(0);
    REQUIRE(document.at(included).included);
    CHECK(place(document, included, {{1, 2, 3}, {}, glm::vec3(1)}) == "");
    Said said;
    const std::string text = store.text(document, &said);
    CHECK(text.find("part.json") == std::string::npos);
    CHECK(said.find("stands in the file itself") != Said::npos);
    CHECK(store.save(document) == said);
    CHECK(read_scene(store.path).objects.size() == 2);
    document.undo();
    CHECK(store.text(document).find("part.json") == std::string::npos);  // the file that was saved includes nothing now
}

TEST_CASE("a step that cannot be shown is undone, is said, and leaves the picture as it was") {
    Driven editor;
    const auto picture = editor.picture();
    SceneObject broken = named("broken", editor.folder.path / "bad.obj");
    write_file(broken.model, "v 0 0 0\nf 1 2 3\n");
    add_object(editor.document(), broken);
    CHECK(editor.picture() == picture);
    CHECK(editor.window.take_notice().find("bad.obj:2") != std::string::npos);
    CHECK(editor.document().done() == 0);
    CHECK(editor.named("broken") == no_entry);
}

TEST_CASE("a texture that is damaged or gone when all is loaded again undoes nothing, and comes back with its file") {
    Driven editor;
    const std::filesystem::path file = editor.folder.path / "own.png";
    const auto keep = [&] { write_png(file, Image8(4, 4, {255, 0, 0, 255})); };
    keep();
    editor.document().begin("texture");
    editor.document().edit(editor.named("left")).object()->material.maps["diffuse"] = file;
    editor.document().commit();
    const auto with = editor.picture();
    for (const bool gone : {false, true}) {
        gone ? void(std::filesystem::remove(file)) : write_file(file, "damaged");
        rename(editor.document(), editor.named(gone ? "second" : "right"),
               gone ? "third" : "second");  // a step that is not to blame
        const std::string before = state_of(editor.document());
        const size_t steps = editor.document().done();
        editor.live.reload();
        CHECK(editor.picture() != with);
        CHECK(editor.window.take_notice().find("own.png") != std::string::npos);
        for (int i = 0; i < 3; ++i) editor.draw();
        duplicate(editor.document(), {editor.named("left")});
        editor.draw();
        CHECK(editor.window.take_notice().empty());  // it was said
        CHECK(editor.document().done() == steps + 1);
        editor.document().undo();
        editor.draw();
        CHECK(state_of(editor.document()) == before);
        // A step that is to blame is undone still.
        write_file(editor.folder.path / "bad.obj", "v 0 0 0\nf 1 2 3\n");
        add_object(editor.document(), named("broken", editor.folder.path / "bad.obj"));
        editor.draw();
        CHECK(state_of(editor.document()) == before);
        CHECK(editor.window.take_notice().find("bad.obj:2") != std::string::npos);
        keep();
        editor.live.reload();
        CHECK(editor.picture() == with);
    }
}

TEST_CASE("where another scene cannot be opened, or one's own not loaded again, all steps can still be undone") {
    Driven editor;
    rename(editor.document(), editor.named("left"), "other");
    editor.draw();
    editor.window.editor.save(editor.window);
    const std::filesystem::path broken = editor.folder.path / "broken.json";
    write_file(broken, R"({"objects": [{"model": "none.obj"}]})");
    editor.window.opens = broken;
    editor.draw();
    CHECK(editor.window.take_notice().find("none.obj") != std::string::npos);
    write_file(editor.folder.path / "scene.json", "{");
    editor.live.reload();
    editor.live.load_error.clear();
    editor.draw();
    REQUIRE(editor.document().done() == 1);
    editor.window.editor.undo(editor.window);
    editor.draw();
    CHECK(editor.named("left") != no_entry);
}

TEST_CASE("a scene that is opened has its own knobs, and none of the scene before; one that fails changes none") {
    Driven editor;
    editor.window.bloom.method.set("paired");
    editor.draw();
    const std::filesystem::path other = editor.folder.path / "other.json", bad = editor.folder.path / "bad.json";
    write_file(other, R"({"knobs": {"fog.method": "height"}})");
    write_file(bad, R"({"objects": [{"model": "none.obj"}]})");
    editor.window.opens = bad;
    editor.draw();
    CHECK(editor.window.take_notice().find("none.obj") != std::string::npos);
    CHECK(editor.window.bloom.method.is("paired"));
    CHECK(editor.named("left") != no_entry);
    editor.window.opens = other;
    editor.draw();
    CHECK(editor.window.bloom.method.is("none"));
    CHECK(editor.window.bench.fog.method.is("height"));
    CHECK(editor.document().done() == 0);
}

TEST_CASE("the tree by keys: what the scene has once, then entries; folded and unfolded; hidden, locked, lights") {
    Driven editor;
    const auto active = [&] { return editor.window.editor.selection.active(); };
    editor.key(GLFW_KEY_UP);  // from nothing: the last one
    CHECK(editor.document().at(active()).light());
    editor.key(GLFW_KEY_UP);
    CHECK(active() == editor.named("right"));
    for (int i = 0; i < 9; ++i) editor.key(GLFW_KEY_UP);
    CHECK(active() == root_entry);
    CHECK(editor.window.editor.selected_items(editor.window.scene) == std::vector<uint32_t>{0, 0});  // not everything
    editor.key(GLFW_KEY_UP);
    CHECK(active() == root_entry);
    for (int i = 0; i < 8; ++i)
        editor.key(GLFW_KEY_DOWN);  // scene, camera, environment, sky, terrain, water, fog, effects, left
    CHECK(active() == editor.named("left"));
    editor.key(GLFW_KEY_H, GLFW_MOD_SHIFT);
    CHECK(editor.document().at(active()).hidden);
    editor.key(GLFW_KEY_H, GLFW_MOD_SHIFT);
    CHECK_FALSE(editor.document().at(active()).hidden);
    editor.key(GLFW_KEY_G, GLFW_MOD_CONTROL);
    const EntryId group = active();
    editor.key(GLFW_KEY_RIGHT);
    editor.key(GLFW_KEY_DOWN);
    CHECK(active() == editor.named("left"));
    editor.key(GLFW_KEY_UP);
    editor.key(GLFW_KEY_LEFT);
    editor.key(GLFW_KEY_UP);
    editor.key(GLFW_KEY_DOWN);
    CHECK(active() == group);
    editor.key(GLFW_KEY_L, GLFW_MOD_SHIFT);
    editor.key(GLFW_KEY_DELETE);
    CHECK(editor.window.take_notice().find("locked") != std::string::npos);
    editor.key(GLFW_KEY_3, GLFW_MOD_SHIFT);
    CHECK(editor.document().at(active()).light()->kind == Light::Kind::spot);
    editor.key(GLFW_KEY_4, GLFW_MOD_SHIFT);
    CHECK(editor.window.editor.selection.ids.size() == 100);
}

TEST_CASE("numbers and choices that change are the document's settings", "[18.settings]") {
    Playground chapter;
    chapter.name = "18_playground";
    Knob<int> asked(chapter, "asked", 1, {0, 1 << 30}, "A number");
    load_scene(chapter, check_device(), "models/cube.obj");
    Frame frame(check_device());
    const auto draw = [&] { render(chapter, frame, {{16, 16}, 0, 0, {}}); };
    draw();
    asked.value = 2;
    draw();
    CHECK(chapter.editor.document.settings().knobs.at("asked") == "2");
    chapter.show.set("ids");  // no setting
    chapter.objects.maps.method.set("flat");
    draw();
    CHECK(chapter.editor.document.settings().knobs.at("maps.method") == "flat");
}
