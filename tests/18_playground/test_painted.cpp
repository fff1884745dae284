// Unchanged parts of a scene: lists after a new colour, knobs of a frame at rest.
#include <nlohmann/json.hpp>

#include "driven_editor.h"
#include "shown_scene.h"

using namespace lightwalk;

namespace {

/// A setting that counts how often it is asked for its text.
struct Asked : Knob<int> {
    explicit Asked(Module& of) : Knob(of, "asked", 1, {0, 1 << 30}, "A number") {}
    std::string text() const override {
        ++texts;
        return Knob::text();
    }
    mutable int texts = 0;
};

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

TEST_CASE("a new colour makes no list and loads nothing; another kind of surface does", "[18.painted]") {
    Shown shown;
    const EntryId a = add_object(shown.document, named("a", ball_file)),
                  b = add_object(shown.document, named("b", quad_file));
    REQUIRE(shown.update() == LiveScene::Done::replaced);
    const auto edit = [&](EntryId id, const auto& change) {
        shown.document.begin("material");
        change(shown.document.edit(id).object()->material);
        shown.document.commit();
        const uint64_t lists = shown.scene.lists_made, placed = shown.scene.placed, painted = shown.scene.painted;
        const LiveScene::Done done = shown.update();
        const bool only_painted = done == LiveScene::Done::painted;
        CHECK(shown.scene.lists_made == lists + !only_painted);
        CHECK((shown.scene.placed == placed) == only_painted);
        CHECK((shown.scene.painted != painted) == only_painted);
        CHECK(shown.live.loads != only_painted);
        check_as_loaded(shown, test_model);
        return done;
    };
    using Material = MaterialOverride;
    CHECK(edit(a, [](Material& m) { m.diffuse = glm::vec3(0.25f, 0, 0); }) == LiveScene::Done::painted);
    CHECK(edit(b, [](Material& m) { m.emissive = glm::vec3(1, 2, 3); }) == LiveScene::Done::painted);
    CHECK(edit(b, [](Material& m) { m.opacity = 0.5f; }) == LiveScene::Done::replaced);
    CHECK(edit(b, [](Material& m) { m.opacity = 0.75f; }) == LiveScene::Done::painted);
    CHECK(edit(b, [](Material& m) { m.opacity = 1; }) == LiveScene::Done::replaced);
    CHECK(edit(a, [](Material& m) { m.roughness = 0.5f; }) == LiveScene::Done::replaced);
    CHECK(edit(a, [](Material& m) { m.roughness = 0.75f; }) == LiveScene::Done::painted);
    CHECK(edit(a, [](Material& m) { m.shininess = 7; }) == LiveScene::Done::painted);
    CHECK(edit(a, [](Material& m) { m.two_sided = true; }) == LiveScene::Done::replaced);
}

TEST_CASE("emission of the whole scene paints materials; bare ones may be of another kind", "[18.repainted]") {
    Shown shown;
    add_object(shown.document, named("a", ball_file));
    const auto shiny = [](const std::filesystem::path& file) {
        Model model = test_model(file);
        Material& material = model.materials[0];
        material.emissive = {1, 2, 3};
        material.has_exponent = material.metallic_roughness = material.microfacets = true;
        material.roughness = 0.25f;
        return model;
    };
    const auto update = [&] { return shown.live.update(shown.gpu, shown.document, shown.scene, shiny); };
    REQUIRE(update() == LiveScene::Done::replaced);
    const auto edit = [&](const auto& change) {
        shown.document.begin("scene");
        change(*shown.document.edit(root_entry).settings());
        shown.document.commit();
        const uint64_t lists = shown.scene.lists_made;
        const LiveScene::Done done = update();
        CHECK(shown.scene.lists_made == lists + (done == LiveScene::Done::replaced));
        CHECK(shown.live.loads == (done == LiveScene::Done::replaced));
        check_as_loaded(shown, shiny);
        return done;
    };
    CHECK(edit([](SceneSettings& s) { s.emission = 2; }) == LiveScene::Done::painted);
    CHECK(edit([](SceneSettings& s) { s.ambient = glm::vec3(1); }) == LiveScene::Done::nothing);
    CHECK(edit([](SceneSettings& s) { s.bare = true; }) == LiveScene::Done::replaced);
    shown.document.undo();
    CHECK(update() == LiveScene::Done::replaced);
    check_as_loaded(shown, shiny);
}

TEST_CASE("a frame at rest asks no setting for its text; numbers and choices that change are the document's",
          "[18.settings]") {
    Playground chapter;
    chapter.name = "18_playground";
    Asked asked(chapter);
    Gpu& gpu = check_device();
    load_scene(chapter, gpu, "models/cube.obj");
    Frame frame(gpu);
    const auto draw = [&] { render(chapter, frame, {{16, 16}, 0, 0, {}}); };
    draw();
    draw();
    const int before = asked.texts;
    draw();
    draw();
    CHECK(asked.texts == before);
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
