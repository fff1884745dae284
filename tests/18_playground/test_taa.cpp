// Temporal anti-aliasing in the editor: no trace of a scene that is gone.
#include <chrono>
#include <filesystem>

#include "common/app/read_picture.h"
#include "driven_editor.h"

using namespace lightwalk;

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
            const std::filesystem::path left = editor.window.editor.store.autosave_file();
            write_file(left, ball);
            std::filesystem::last_write_time(left,
                                             std::filesystem::file_time_type::clock::now() + std::chrono::seconds(5));
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
