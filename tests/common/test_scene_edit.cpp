// An editor's needs of scenes: hidden things in the file, numbers that are short and exact, objects that come and go.
#include "scene_fixture.h"

using namespace lightwalk;

TEST_CASE("scene files keep hidden objects and lights in their places, names of lights, and whose knobs they have") {
    const std::string text = R"({"objects": [{"name": "a", "hidden": true}, {"name": "b", "parent": "a"}],
        "lights": [{"name": "first", "type": "point"}, {"type": "spot", "hidden": true}, {"type": "point", "intensity": 0.1}],
        "knobs_of": "18_playground", "knobs": {"x": 1}})";
    const SceneFile scene = parse_scene(text, "scene.json");
    CHECK(scene.objects[0].hidden);
    CHECK_FALSE(scene.objects[1].hidden);
    REQUIRE(scene.lights.size() == 2);
    CHECK(scene.lights[0].name == "first");
    REQUIRE(scene.hidden_lights.size() == 1);
    CHECK(scene.hidden_lights[0].before == 1);
    CHECK(scene.knobs_of == "18_playground");
    const std::string written = scene_text(scene);
    CHECK(written.find("\"intensity\": 0.1,") != std::string::npos);
    CHECK(scene_text(parse_scene(written, "scene.json")) == written);
    CHECK(error_of(R"({"objects": [{"hidden": 1}]})").find("hidden") != std::string::npos);
    CHECK(error_of(R"({"lights": [{"locked": 1}]})").find("locked") != std::string::npos);
    CHECK(error_of(R"({"knobs_of": 18})").find("knobs_of") != std::string::npos);
}

TEST_CASE("a hidden object has no items, nor have its children; shown again they are where they were") {
    TestScene test({object_at(quad_file, {0, 0, 0}), object_at(ball_file, {2, 0, 0})});
    std::vector<SceneObject> objects = test.scene.file.objects;
    const std::vector<uint32_t> same{0, 1};
    objects[0].hidden = true;
    test.scene.replace_objects(test.gpu, objects, same, test_model);
    REQUIRE(test.scene.items.size() == 1);
    CHECK(test.scene.items[0].transform[3].x == 2);
    objects[0].hidden = false;
    test.scene.replace_objects(test.gpu, objects, same, test_model);
    CHECK(test.scene.items.size() == 2);
    CHECK(test.on_device().size() == 2);
}

TEST_CASE("moved objects take their children along, and the device is told of no others") {
    std::vector<SceneObject> objects{object_at(quad_file, {0, 0, 0}), object_at(quad_file, {1, 0, 0}),
                                     object_at(quad_file, {3, 3, 0})};
    objects[0].name = "parent";
    objects[1].parent = "parent";
    TestScene test(objects);
    const uint64_t before = test.scene.epoch;
    objects[0].position = {0, 2, 0};
    objects[0].rotation_deg = {0, 0, 90};
    const Scene::Edit edit{0, &objects[0]};
    CHECK(test.scene.edit({&edit, 1}));
    CHECK(test.scene.epoch != before);
    for (const DrawItem& item : test.scene.items) {
        const glm::vec3 at(item.transform[3]), right = item.object == 0   ? glm::vec3(0, 2, 0)
                                                       : item.object == 1 ? glm::vec3(0, 3, 0)
                                                                          : glm::vec3(3, 3, 0);
        CHECK(glm::length(at - right) < 1e-6f);
    }
    Frame frame(test.gpu);
    TestScene::begin(frame);
    const uint64_t uploaded = test.gpu.uploaded_bytes;
    test.scene.upload_moved(frame);
    frame.end();
    CHECK(test.gpu.uploaded_bytes - uploaded == 2 * sizeof(Instance));
}

TEST_CASE("a material that is edited and taken back is the one before") {
    TestScene test({object_at(quad_file, {0, 0, 0})});
    SceneObject object = test.scene.file.objects[0];
    const glm::vec3 before = test.scene.items[0].material.diffuse, other(0.25f, 0.5f, 0.125f);
    const Scene::Edit edit{0, &object};
    for (const auto& color : {std::optional(other), std::optional<glm::vec3>()}) {
        object.material.diffuse = color;
        CHECK(test.scene.edit({&edit, 1}));
        CHECK(test.scene.items[0].material.diffuse == color.value_or(before));
    }
}

TEST_CASE("objects that cannot be loaded leave the scene as it was") {
    TestScene test({object_at(quad_file, {0, 0, 0})});
    std::vector<SceneObject> objects = test.scene.file.objects;
    objects.push_back(object_at("models/none.obj", {0, 0, 0}));
    const std::vector<uint32_t> from{0, Scene::new_object};
    CHECK_THROWS_AS(test.scene.replace_objects(test.gpu, objects, from, test_model), InputError);
    CHECK(test.scene.file.objects.size() == 1);
    CHECK(test.scene.items.size() == 1);
}
