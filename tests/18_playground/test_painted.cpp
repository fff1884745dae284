// Edits of materials and settings.
#include <nlohmann/json.hpp>

#include "driven_editor.h"

using namespace lightwalk;

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

TEST_CASE("the shadow of glass has its new colour at once", "[18.painted_shadow]") {
    const auto glass_of = [](const char* color, float opacity) {
        return fmt::format(R"({{"camera": {{"position": [0, 3, 6], "target": [0, 0, 0]}}, "ambient": [0.1, 0.1, 0.1],
    "knobs": {{"shadow.transparent": "colored"}},
    "lights": [{{"type": "directional", "direction": [-0.3, -0.9, -0.1], "shadow": true}}],
    "objects": [{{"name": "floor", "model": "models/cube.obj", "scale": [8, 0.1, 8], "position": [0, -1.5, 0]}},
        {{"name": "glass", "model": "models/cube.obj", "position": [0, 1, 0],
          "material": {{"diffuse": {}, "opacity": {}}}}}]}})",
                           color, opacity);
    };
    for (const float opacity : {0.5f, 1.0f}) {  // of the other kind, too: a solid cube becomes glass
        Driven edited(glass_of("[1, 0, 0]", opacity).c_str()), fresh(glass_of("[0, 0, 1]", 0.5f).c_str());
        const std::vector<std::byte> red = edited.picture();
        edited.document().begin("material");
        MaterialOverride& material = edited.document().edit(edited.named("glass")).object()->material;
        material.diffuse = glm::vec3(0, 0, 1);
        material.opacity = 0.5f;
        edited.document().commit();
        const std::vector<std::byte> blue = edited.picture();
        const bool changes = blue != red, is_right = blue == fresh.picture();
        CHECK(changes);
        CHECK(is_right);
    }
}
