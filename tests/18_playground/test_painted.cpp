// Edits of materials and settings, and what the scene on the device has of them.
#include <nlohmann/json.hpp>

#include "driven_editor.h"
#include "shown_scene.h"

using namespace lightwalk;

namespace {

// As a new scene of the document has it, on the device as well after a frame.
void check_as_loaded(Shown& shown, const ModelLoader& loader) {
    Scene fresh;
    fresh.load(shown.gpu, exported(shown.document).scene, loader);
    CHECK(items_of(shown.scene) == items_of(fresh));
    Frame frame(shown.gpu);
    TestScene::begin(frame);
    shown.scene.upload_moved(frame);
    frame.end();
    CHECK(shown.gpu.read_back(shown.scene.materials) == shown.gpu.read_back(fresh.materials));
}

}  // namespace

TEST_CASE("after an edit of a material or of the whole scene it is as a new scene of the document", "[18.painted]") {
    Shown shown;
    const EntryId id = add_object(shown.document, named("a", ball_file));
    const auto shiny = [](const std::filesystem::path& file) {
        Model model = test_model(file);
        Material& material = model.materials[0];
        material.emissive = {1, 2, 3};
        material.has_exponent = material.metallic_roughness = material.microfacets = true;
        material.roughness = 0.25f;
        return model;
    };
    const auto edit = [&](EntryId entry, const auto& change) {
        shown.document.begin("edit");
        change(shown.document.edit(entry));
        shown.document.commit();
        shown.live.update(shown.gpu, shown.document, shown.scene, shiny);
        check_as_loaded(shown, shiny);
    };
    using Change = void (*)(MaterialOverride&);
    for (const Change change : std::initializer_list<Change>{
             [](MaterialOverride& m) { m.diffuse = glm::vec3(0.25f, 0, 0); },
             [](MaterialOverride& m) { m.emissive = glm::vec3(1, 2, 3); },
             [](MaterialOverride& m) { m.opacity = 0.5f; }, [](MaterialOverride& m) { m.opacity = 1; },
             [](MaterialOverride& m) { m.roughness = 0.5f; }, [](MaterialOverride& m) { m.shininess = 7; },
             [](MaterialOverride& m) { m.two_sided = true; }})
        edit(id, [&](auto& entry) { change(entry.object()->material); });
    edit(root_entry, [](auto& entry) { entry.settings()->emission = 2; });
    edit(root_entry, [](auto& entry) { entry.settings()->bare = true; });
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
