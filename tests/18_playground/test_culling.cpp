// Culling in the editor: begins by itself where there is much to leave out, and changes no picture.
#include <fmt/core.h>

#include "common/app/read_picture.h"
#include "driven_editor.h"

using namespace lightwalk;

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

std::vector<glm::vec3> picture(Driven& editor, glm::uvec2 size) {
    editor.live.draw(editor.frame, {.size = size, .crop = {}});
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
        const glm::uvec2 size = i < 5 ? glm::uvec2(81, 45) : glm::uvec2(64, 61);
        if (i > 0) editor.window.camera.position += glm::vec3(i == 4 ? 9.0f : 0.3f, 0.1f, i == 6 ? -5.0f : 0.0f);
        if (i == 3) place(editor.document(), editor.named("wall"), {{3, 2, 2}, {}, glm::vec3(4, 6, 0.2f)});
        const auto culled = picture(editor, size);
        const size_t drawn = culling.drawn(), tested = culling.tested();
        culling.method.set("none");
        const auto all = picture(editor, size);
        culling.method.set("occlusion");
        INFO("frame " << i);
        CHECK(culled == all);
        CHECK(tested == 4001);
        CHECK(drawn < tested);
        if (i == 2) CHECK(2 * drawn < tested);  // behind the wall
    }
}
