// The editor without a screen: frames, the mouse and keys as its window would give them.
#pragma once
#include "18_playground/editor_window.h"
#include "common/app/render.h"
#include "common/window/live_chapter.h"
#include "editor_fixture.h"

namespace lightwalk {

inline const char* const two_cubes =
    R"({"camera": {"position": [0, 0.5, 4], "target": [0, 0, 0]}, "ambient": [0.3, 0.3, 0.3],
    "lights": [{"type": "directional", "direction": [-0.4, -0.8, -0.5]}],
    "objects": [{"name": "left", "model": "models/cube.obj"}, {"name": "right", "model": "models/cube.obj", "position": [2, 0, 0]}]})";

/// The editor as its window drives it, one frame after each event.
struct Driven {
    FileFolder folder;
    Gpu& gpu = check_device();
    EditorWindow window;
    LiveChapter live;
    Frame frame{gpu};
    glm::vec2 cursor{0.0f};
    explicit Driven(const char* scene = two_cubes) : live(window, gpu, write(scene)) {
        window.name = "18_playground";
        window.bench.light.prefilter.samples.change_default("1");  // no case looks at reflections
        live.load({});
        draw();
    }
    std::filesystem::path write(const char* scene) {
        write_file(folder.path / "scene.json", scene);
        return folder.path / "scene.json";
    }
    void draw() {
        window.is_busy();  // as the window asks before each frame
        live.draw(frame, {{160, 120}, 0, 0, {}});
        REQUIRE(live.frame_error == "");
    }
    std::vector<std::byte> picture() {
        draw();
        return gpu.read_back(frame.output);
    }
    bool mouse(glm::vec2 at, bool down) {
        Input input;
        cursor = input.cursor = at;
        input.left = down;
        const bool taken = window.on_mouse(input, at, true);
        draw();
        return taken;
    }
    void key(int key, int mods = 0) {
        window.on_key({key, mods});
        draw();
    }
    EntryId named(const std::string& name) {
        for (const EntryId id : with_children(document(), root_entry))
            if (document().at(id).name() == name) return id;
        return no_entry;
    }
    Document& document() { return window.editor.document; }
    /// By the arrow along x.
    void begin_drag(const std::string& name) {
        window.editor.selection.set({named(name)});
        draw();
        const auto place = gizmo_place(document(), window.editor.selection, window.view_now, Tool::move, false);
        REQUIRE(place);
        const glm::vec2 at = *on_screen(window.view_now, place->pivot + 0.6f * place->length_m * place->axes[0]);
        mouse(at, false);
        CHECK(mouse(at, true));
        REQUIRE(window.editor.drag);
        mouse(at + glm::vec2(9, 0), true);
        CHECK(x_of(name) != first_x[name]);
    }
    float x_of(const std::string& name) { return document().at(named(name)).object()->position.x; }
    std::map<std::string, float> first_x{{"left", 0.0f}, {"right", 2.0f}};
};

}  // namespace lightwalk
