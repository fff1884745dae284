// Scenes as they are drawn: batches, lists, mirrored objects, and the placement of it all.
#include <glm/gtc/matrix_transform.hpp>
#include <random>

#include "catch.h"
#include "common/image/image.h"
#include "scene_fixture.h"

using namespace lightwalk;

namespace {

SceneObject with_opacity(SceneObject object, float opacity) {
    object.material.opacity = opacity;
    return object;
}

std::vector<std::string> names(const Scene& scene, const DrawList& list) {
    std::vector<std::string> result;
    for (const uint32_t i : list.items()) result.push_back(scene.file.objects[scene.items[i].object].name);
    return result;
}

SceneObject named(const char* name, SceneObject object) {
    object.name = name;
    return object;
}

using Names = std::vector<std::string>;

}  // namespace

TEST_CASE("equal parts are instances of one batch; opaque ones come first, otherwise the file's order stays") {
    TestScene test({named("a", object_at(quad_file, {-3, 0, 0})), named("b", object_at(other_file, {-1, 0, 0})),
                    named("glass", with_opacity(object_at(quad_file, {1, 2, 0}), 0.5f)),
                    named("c", object_at(quad_file, {1, 0, 0})), named("d", object_at(quad_file, {3, 0, 0})),
                    named("mirror", object_at(quad_file, {3, 3, 0}, {-1, 1, 1}))});
    const auto batches = test.scene.batches();
    std::vector<uint32_t> counts;
    for (const Batch& batch : batches) counts.push_back(batch.count);
    CHECK(counts == std::vector<uint32_t>{3, 1, 1, 1});
    CHECK(names(test.scene, test.scene.all()) == Names{"a", "c", "d", "b", "mirror", "glass"});
    CHECK(batches[2].item().mirrored);
    CHECK(batches[3].item().transparent);
    const TestScene two({object_at(quad_file, {0, 0, 0}), with_opacity(object_at(quad_file, {0, 0, 0}), 0.5f)});
    CHECK(two.scene.batches().size() == 2);
}

// A batch is drawn by one shader: a scene that gives an exponent to one of two equal metals asks for two.
TEST_CASE("equal parts of another reflection model are another batch", "[common.batch_model]") {
    SceneFile file;
    file.objects = {object_at(quad_file, {-1, 0, 0}), object_at(quad_file, {1, 0, 0})};
    file.objects[1].material.shininess = 50.0f;
    Scene scene;
    scene.load(check_device(), std::move(file), [](const std::filesystem::path& name) {
        Model model = test_model(name);
        model.materials[0].metallic_roughness = model.materials[0].microfacets = true;
        return model;
    });
    REQUIRE(scene.batches().size() == 2);
    for (const Batch& batch : scene.batches()) CHECK(batch.item().material.microfacets == (batch.item().object == 0));
}

TEST_CASE("an instance is its own item: gl_InstanceIndex is its place, and numbers of its material are its own") {
    std::vector<SceneObject> objects;
    for (int i = 0; i < 4; ++i) {
        objects.push_back(object_at(i % 2 ? other_file : quad_file, {-3 + 2 * i, 0, 0}, glm::vec3(0.5f)));
        objects.back().material.diffuse = glm::vec3(0.25f * float(i + 1));
    }
    TestScene test(objects);
    const auto seen = test.seen(test.scene, {{-2.9f, 0}, {-0.9f, 0}, {1.1f, 0}, {3.1f, 0}, {0, 2}});
    for (size_t i = 0; i < 4; ++i) {
        const auto item = static_cast<size_t>(seen[i].r);
        REQUIRE(item >= 1);
        CHECK(test.scene.items[item - 1].object == i);
        CHECK(seen[i].g == 0.25f * float(i + 1));
    }
    CHECK(seen[4] == glm::vec4(0.0f));
}

TEST_CASE("a mirrored object shows its outside: lit 1 from the camera, as its front") {
    for (const glm::vec3 scale : {glm::vec3(1), glm::vec3(-1, 1, 1), glm::vec3(1, -1, -1), glm::vec3(-2)}) {
        CAPTURE(scale.x, scale.y, scale.z);
        TestScene test({object_at(ball_file, {0, 0, 0}, scale)});
        const glm::vec4 seen = test.seen(test.scene, {{0.1f, -0.1f}})[0];
        CHECK(seen.b > 0.98f);
        CHECK(seen.a == 1.0f);
    }
    // A quad below a mirrored node; mirrored once more it is as modelled.
    const std::string file = (course_root() / "tests/common/data/mirrored.gltf").string();
    for (const float x : {1.0f, -1.0f}) {
        TestScene test({object_at(file.c_str(), {0, 0, 0}, {x, 1, 1})});
        CHECK(test.scene.items[0].mirrored == (x > 0));
        const glm::vec4 seen = test.seen(test.scene, {{0.1f, -0.1f}})[0];
        CHECK(seen.b == 1.0f);
        CHECK(seen.a == 1.0f);
    }
}

TEST_CASE("transparent: opacity below 1, or a material that blends; a scene file may say otherwise") {
    const std::string file = (course_root() / "tests/common/data/moving.gltf").string();  // alphaMode BLEND
    auto cut = named("cut", object_at(file.c_str(), {0, 0, 0}));
    cut.material.blend = false;
    auto smoke = named("smoke", object_at(quad_file, {0, 0, 0}));
    smoke.material.blend = true;
    const TestScene test({named("glass", with_opacity(object_at(quad_file, {0, 0, 0}), 0.99f)),
                          named("wall", object_at(quad_file, {0, 0, 0})), cut, smoke,
                          named("model", object_at(file.c_str(), {0, 0, 0}))});
    CHECK(names(test.scene, test.scene.opaque()) == Names{"wall", "cut"});
    CHECK(names(test.scene, test.scene.transparent()) == Names{"glass", "smoke", "model"});
}

TEST_CASE("sorted: the farthest first, equals in their order; lists can be narrowed further") {
    TestScene test({named("near", object_at(quad_file, {0, 0, 3})), named("far", object_at(quad_file, {0, 0, -3})),
                    named("left", object_at(quad_file, {-2, 0, 0})), named("right", object_at(quad_file, {2, 0, 0})),
                    named("other", object_at(other_file, {0, 0, -1}))});
    const DrawList sorted = test.scene.all().sorted_from({0, 0, 10});
    CHECK(names(test.scene, sorted) == Names{"far", "other", "left", "right", "near"});
    CHECK(sorted.batches().size() == 4);  // left and right stand together
    CHECK(names(test.scene, test.scene.all().sorted_from({0, 0, -10})) ==
          Names{"near", "left", "right", "other", "far"});
    const DrawList few = sorted.where([](const DrawItem& item) { return item.transform[3].z <= 0; });
    CHECK(names(test.scene, few) == Names{"far", "other", "left", "right"});
    // Drawn one after the other with equal depth the last one shows; sorting decides which that is.
    TestScene flat({object_at(quad_file, {0, 0, 0}), object_at(other_file, {0.5f, 0, 0})});
    CHECK(flat.seen(flat.scene.all().sorted_from({9, 0, 0}), {{0.1f, 0.1f}})[0].r == 2.0f);
    CHECK(flat.seen(flat.scene.all().sorted_from({-9, 0, 0}), {{0.1f, 0.1f}})[0].r == 1.0f);
}

TEST_CASE("inside keeps every box of which a point shows, and drops most of the others") {
    std::mt19937 random(7);
    const auto number = [&](float lower, float upper) {
        return std::uniform_real_distribution<float>(lower, upper)(random);
    };
    const auto somewhere = [&](float reach) {
        return glm::vec3(number(-reach, reach), number(-reach, reach), number(-reach, reach));
    };
    // Depth 1 near and 0 at infinity, 0 at 40 m, and without perspective.
    glm::mat4 infinite(0.0f), finite(0.0f), flat(1.0f);
    infinite[0][0] = 1.2f;
    infinite[1][1] = -1.6f;
    infinite[2][3] = -1.0f;
    infinite[3][2] = 0.1f;
    finite = infinite;
    finite[2][2] = 0.1f / (40 - 0.1f);
    finite[3][2] = 40 * 0.1f / (40 - 0.1f);
    flat[0][0] = 0.1f;
    flat[1][1] = -0.1f;
    flat[2][2] = 0.02f;
    flat[3][2] = 0.9f;
    int shown = 0, dropped = 0, hidden = 0;
    for (int i = 0; i < 3000; ++i) {
        const glm::mat4 look = glm::lookAt(somewhere(20), somewhere(20), glm::normalize(somewhere(1)));
        const glm::mat4 matrix = (i % 3 == 0 ? infinite : i % 3 == 1 ? finite : flat) * look;
        Bounds box;
        box.add(somewhere(30));
        box.add(box.lower + glm::abs(somewhere(i % 5 ? 3 : 40)));
        bool shows = false;
        for (int k = 0; k < 1000 && !shows; ++k) {
            const glm::vec3 at = glm::vec3(k % 10, k / 10 % 10, k / 100) / 9.0f;
            const glm::vec4 p = matrix * glm::vec4(glm::mix(box.lower, box.upper, at), 1.0f);
            shows = std::abs(p.x) <= p.w && std::abs(p.y) <= p.w && p.z >= 0 && p.z <= p.w;
        }
        const bool kept = may_show(box, matrix);
        if (shows && !kept) FAIL_CHECK("a box that shows was dropped, run " << i);
        shown += shows;
        hidden += !shows;
        dropped += !kept;
    }
    CHECK(shown > 300);
    CHECK(dropped > 0.9 * hidden);
    Bounds around;  // the eye within, no corner seen
    around.add({-500, -500, -500});
    around.add({500, 500, 500});
    CHECK(may_show(around, finite));
    TestScene test(
        {object_at(quad_file, {0, 0, -5}), object_at(quad_file, {0, 0, 5}), object_at(quad_file, {0, 0, -50})});
    CHECK(test.scene.all().inside(finite).items() == std::vector<uint32_t>{0});
    CHECK(test.scene.all().inside(infinite).items() == std::vector<uint32_t>{0, 2});
}

TEST_CASE("normals stay upright on what is stretched: the inverse transpose, on the device too") {
    TestScene test({object_at(quad_file, {0, 0, 0}, {1, 4, 1})});
    const glm::mat3 normals = test.on_device()[0].normal_matrix;
    const glm::vec3 along = glm::mat3(test.scene.items[0].transform) * glm::vec3(1, -1, 0);
    CHECK(std::abs(glm::dot(normals * glm::vec3(1, 1, 0), along)) < 1e-6f);
    CHECK(glm::length(normals * glm::vec3(0, 1, 0) - glm::vec3(0, 0.25f, 0)) < 1e-6f);
}

TEST_CASE("a turned object's bounds hold all of it and no more than its turned box") {
    auto ball = object_at(ball_file, {1, 2, 3}, {1, 2, 3});
    ball.rotation_deg = {30, 45, 60};
    auto quad = object_at(quad_file, {0, 0, 0});
    quad.rotation_deg = {0, 45, 0};
    const TestScene test({ball, quad});
    for (const Vertex& v : ball_mesh().vertices) {
        const auto p = glm::vec3(test.scene.items[0].transform * glm::vec4(v.position, 1.0f));
        const Bounds& box = test.scene.items[0].bounds;
        CHECK((glm::all(glm::greaterThan(p, box.lower - 1e-4f)) && glm::all(glm::lessThan(p, box.upper + 1e-4f))));
    }
    const float half = std::sqrt(0.5f);
    CHECK(glm::length(test.scene.items[1].bounds.upper - glm::vec3(half, 1, half)) < 1e-5f);
    CHECK(glm::length(test.scene.items[1].bounds.lower + glm::vec3(half, 1, half)) < 1e-5f);
}

TEST_CASE("an environment is loaded as halves with mips, in linear light; without one there is none") {
    TestScene test({object_at(quad_file, {0, 0, 0})});
    CHECK(test.scene.environment == nullptr);
    const FileFolder folder;
    const auto file = folder / "sky.pfm";
    ImageRgb sky(8, 4);
    for (int x = 0; x < 8; ++x) sky.at(x, 0) = glm::vec3(float(x), 1000.0f, 0.25f);
    write_pfm(file, sky);
    SceneFile scene = test.scene.file;
    scene.environment.image = file;
    test.scene.load(test.gpu, scene, test_model);
    REQUIRE(test.scene.environment);
    const Image& image = *test.scene.environment;
    CHECK(image.desc.format == VK_FORMAT_R16G16B16A16_SFLOAT);
    CHECK(image.desc.size == glm::uvec2(8, 4));
    CHECK(image.desc.mips == 4);
    const auto bytes = test.gpu.read_back(image);
    uint64_t texel = 0;
    std::memcpy(&texel, &bytes[8 * 3], 8);
    CHECK(glm::unpackHalf4x16(texel) == glm::vec4(3, 1000, 0.25f, 1));
    test.scene.load(test.gpu, SceneFile(), test_model);
    CHECK(test.scene.environment == nullptr);
}
