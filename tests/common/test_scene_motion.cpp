// Scenes that move: placement at a time, and minimal uploads.
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "catch.h"
#include "common/scene/bare.h"
#include "scene_fixture.h"

using namespace lightwalk;

namespace {

Motion path(std::vector<Keyframe> keys, float period_s = 0) {
    Motion motion;
    motion.path = std::move(keys);
    motion.period_s = period_s;
    return motion;
}

Keyframe key(float time_s, glm::vec3 position, glm::vec3 scale = glm::vec3(1.0f)) {
    return {time_s, position, glm::vec3(0.0f), scale};
}

bool near(glm::vec3 a, glm::vec3 b) { return glm::length(a - b) < 1e-4f; }

SceneObject spinning(const char* file, glm::vec3 position) {
    SceneObject object = object_at(file, position);
    object.name = "hub";
    object.motion.spin_deg_per_s = 90;
    return object;
}

bool same(const Instance& a, const Instance& b) {
    return a.model == b.model && a.normal_matrix == b.normal_matrix && a.material == b.material;
}

}  // namespace

TEST_CASE("a path goes through its keyframes, along a straight line at even speed, and rests at its ends") {
    const Motion line = path({key(0, {0, 0, 0}), key(1, {1, 0, 0}), key(3, {3, 0, 0}), key(4, {4, 0, 0})});
    for (const float t : {0.0f, 0.25f, 1.0f, 2.0f, 2.9f, 4.0f}) CHECK(path_at(line, t).position.x == Approx(t));
    CHECK(path_at(line, -5).position.x == 0);
    CHECK(path_at(line, 9).position.x == 4);
    // Catmull and Rom, in the middle of four points at even times: (9 (b + c) - (a + d)) / 16.
    const Motion bend = path({key(0, {0, 0, 0}), key(1, {0, 1, 0}), key(2, {0, 5, 0}), key(3, {0, 2, 0})});
    CHECK(path_at(bend, 1.5f).position.y == Approx((9 * (1 + 5) - (0 + 2)) / 16.0));
    CHECK(path_at(path({key(7, {1, 2, 3})}), 0).position == glm::vec3(1, 2, 3));
}

TEST_CASE("a closed path comes round, smoothly, before the first keyframe and after the last") {
    const Motion square = path({key(1, {1, 0, 0}), key(2, {0, 1, 0}), key(3, {-1, 0, 0}), key(4, {0, -1, 0})}, 4);
    CHECK(near(path_at(square, 5).position, {1, 0, 0}));
    CHECK(near(path_at(square, -2).position, {0, 1, 0}));
    CHECK(near(path_at(square, 4.5f).position, path_at(square, 0.5f).position));
    for (const float t : {1e30f, -1e30f}) CHECK(glm::length(path_at(square, t).position) <= 1.01f);
    CHECK(near(path_at(square, 4.5f).position, {0.625f, -0.625f, 0}));  // as every other quarter
    CHECK(near(path_at(square, 2.5f).position, {-0.625f, 0.625f, 0}));
    const glm::vec3 before = path_at(square, 4.999f).position, at = path_at(square, 5).position,
                    after = path_at(square, 5.001f).position;
    CHECK(glm::length((at - before) - (after - at)) < 1e-5f);
}

TEST_CASE("a scale never passes through 0, however short the dip") {
    const Motion dip = path({key(0, {}, glm::vec3(-1, 1, 1)), key(1, {}, glm::vec3(-0.01f, 1, 1)),
                             key(2, {}, glm::vec3(-0.01f, 1, 1)), key(3, {}, glm::vec3(-1, 1, 1))});
    for (float t = 0; t < 3; t += 0.01f) CHECK(path_at(dip, t).scale.x < 0);
    CHECK(path_at(dip, 1).scale.x == Approx(-0.01f));
    CHECK(path_at(dip, 1.5f).scale.y == 1);
}

TEST_CASE("a spin turns about its axis in the object's own space, before the object's rotation") {
    SceneObject object = spinning(quad_file, {1, 0, 0});
    object.rotation_deg = {0, 0, 90};  // the axis +y becomes -x
    const auto at = [&](glm::vec3 p, float t) { return glm::vec3(local_transform(object, t) * glm::vec4(p, 1.0f)); };
    CHECK(near(at({0, 1, 0}, 1), {0, 0, 0}));
    CHECK(near(at({1, 0, 0}, 1), {1, 0, -1}));
    CHECK(near(at({1, 0, 0}, 5), {1, 0, -1}));
    object.motion.axis = {0, 0, -3};
    CHECK(near(at({1, 0, 0}, 1), {2, 0, 0}));
}

TEST_CASE("children follow, bounds follow, and a time places everything whatever was shown before") {
    SceneObject child = object_at(ball_file, {2, 0, 0});
    child.parent = "hub";
    TestScene test({spinning(quad_file, {0, 0, 0}), child, object_at(other_file, {0, 3, 0})});
    Scene& scene = test.scene;
    CHECK(scene.moves());
    const uint64_t loaded = scene.epoch;
    const auto child_at = [&] { return glm::vec3(scene.items[1].transform[3]); };
    CHECK(near(child_at(), {2, 0, 0}));
    animate(scene, 0);
    CHECK(scene.epoch == loaded);  // it is where it was
    animate(scene, 1);
    CHECK(scene.epoch != loaded);
    CHECK(near(child_at(), {0, 0, -2}));
    CHECK(near(scene.items[1].bounds.center(), {0, 0, -2}));
    CHECK(near(scene.items[1].bounds.extent(), {2, 2, 2}));
    CHECK(scene.bounds.lower.z == Approx(-3));
    CHECK(scene.bounds.upper.x == Approx(1));  // nothing is left where the child was
    animate(scene, 7.3f);
    animate(scene, 1);
    CHECK(near(child_at(), {0, 0, -2}));
    TestScene again({object_at(quad_file, {0, 0, 0})});
    CHECK(again.scene.epoch != scene.epoch);
}

TEST_CASE("a child that moves itself moves in its parent's space") {
    SceneObject child = object_at(quad_file, {9, 9, 9});
    child.parent = "hub";
    child.motion = path({key(0, {1, 0, 0}), key(1, {3, 0, 0})});
    TestScene test({spinning("", {0, 5, 0}), child});
    animate(test.scene, 1);
    CHECK(near(glm::vec3(test.scene.items[0].transform[3]), {0, 5, -3}));
}

TEST_CASE("only what has moved is uploaded; a scene without motion uploads nothing and records no pass") {
    SceneObject child = object_at(ball_file, {2, 0, 0});
    child.parent = "hub";
    TestScene test(
        {object_at(other_file, {0, 3, 0}), spinning(quad_file, {0, 0, 0}), object_at(other_file, {0, -3, 0}), child});
    const auto frame_at = [&](TestScene& of, float time_s) {
        const uint64_t before = of.gpu.uploaded_bytes;
        Frame frame(of.gpu);
        TestScene::begin(frame);
        animate(of.scene, time_s);
        of.scene.upload_moved(frame);
        of.draw(frame, of.scene);
        frame.end();
        return std::pair(of.gpu.uploaded_bytes - before, frame.times.size());
    };
    CHECK(frame_at(test, 0) == std::pair<uint64_t, size_t>(0, 1));
    CHECK(frame_at(test, 1) == std::pair<uint64_t, size_t>(2 * sizeof(Instance), 2));
    CHECK(frame_at(test, 1) == std::pair<uint64_t, size_t>(0, 1));
    const auto on_device = test.on_device();
    for (size_t i = 0; i < on_device.size(); ++i) CHECK(same(on_device[i], instance_of(test.scene.items[i], i)));
    TestScene still({object_at(quad_file, {0, 0, 0})});
    CHECK_FALSE(still.scene.moves());
    CHECK(frame_at(still, 3) == std::pair<uint64_t, size_t>(0, 1));
}

TEST_CASE("a frame shows a moved object where it is: the upload comes before the draw") {
    SceneObject object = object_at(quad_file, {-3, 0, 0});
    object.motion = path({key(0, {-3, 0, 0}), key(1, {3, 0, 0})});
    TestScene test({object});
    const std::vector<glm::vec2> places{{-2.9f, 0.1f}, {2.9f, 0.1f}};
    animate(test.scene, 1);
    auto seen = test.seen(test.scene, places);
    CHECK((seen[0].r == 0 && seen[1].r == 1));
    animate(test.scene, 0);
    seen = test.seen(test.scene, places);
    CHECK((seen[0].r == 1 && seen[1].r == 0));
}

TEST_CASE("a model's own animation moves its nodes, and begins anew when it has ended") {
    const std::string file = (course_root() / "tests/common/data/moving.gltf").string();
    // The cart goes by (2, 0, 0) in the first second and by (0, 4, 0) in the second. The quad on it is 3 m above in z,
    // twice as wide, and turns by 180 degrees about z in two seconds.
    TestScene test({object_at(file.c_str(), {0, 0, 1})});
    const auto at = [&](float time_s, glm::vec3 p) {
        animate(test.scene, time_s);
        return glm::vec3(test.scene.items[0].transform * glm::vec4(p, 1.0f));
    };
    CHECK(test.scene.moves());
    CHECK(near(at(0, {1, 0, 0}), {2, 0, 4}));
    CHECK(near(at(0.5f, {0, 0, 0}), {1, 0, 4}));
    CHECK(near(at(1, {1, 0, 0}), {2, 2, 4}));
    CHECK(near(at(1.5f, {0, 0, 0}), {2, 2, 4}));
    CHECK(near(at(2.5f, {0, 0, 0}), {1, 0, 4}));
    CHECK(near(test.scene.bounds.center(), {1, 0, 4}));
    const Model model = import_model(file);
    CHECK(model.motions.size() == 2);
    CHECK(model.motions_s == Approx(2));
    CHECK(import_model(course_root() / "tests/common/data/mirrored.gltf").motions.empty());
}

TEST_CASE("a part that an animation mirrors leaves its batch and still shows its front") {
    TestScene test({object_at(pair_file, {0, 0, 0})});
    for (const float time_s : {0.0f, 1.0f, 3.1f}) {
        CAPTURE(time_s);
        animate(test.scene, time_s);
        CHECK(test.scene.batches().size() == (time_s == 1.0f ? 2 : 1));
        const auto seen = test.seen(test.scene, {{0.1f, 0.1f}, {2.5f, 0.1f}});
        CHECK((seen[0].a == 1.0f && seen[1].a == 1.0f));
    }
}

namespace {

// The ball, all of whose vertices follow two joints by these shares; `above`: the place of the joints' parent.
Model skinned_ball(std::vector<glm::mat4> joints, glm::vec4 shares, const glm::mat4& above = glm::mat4(1.0f)) {
    Model model = test_model("sphere.obj");
    const int armature = static_cast<int>(model.nodes.size());
    model.nodes.push_back({.name = "armature", .local = above});
    ModelSkin& skin = model.skins.emplace_back();
    for (size_t i = 0; i < joints.size(); ++i) {
        skin.joints.push_back(static_cast<uint32_t>(model.nodes.size()));
        skin.inverse_bind.emplace_back(1.0f);
        model.nodes.push_back({.name = "joint", .parent = armature, .local = joints[i]});
    }
    Deformation& how = model.meshes[0].deformation;
    how.rest = model.meshes[0].vertices;
    how.joints.assign(how.rest.size(), {0, 1, 0, 0});
    how.joint_weights.assign(how.rest.size(), shares);
    deform_at_rest(model);
    return model;
}

// It moves, so that the device deforms it; the node that moves has no mesh.
void set_in_motion(Model& model) {
    model.motions.push_back({.node = static_cast<uint32_t>(model.nodes.size())});
    model.nodes.push_back({.name = "elsewhere"});
    NodeMotion& motion = model.motions.back();
    motion.position = {{0, {0, 0, 0}}, {1, {1, 0, 0}}};
    motion.rotation = {{0, {1, 0, 0, 0}}};
    motion.scale = {{0, {1, 1, 1}}};
    model.motions_s = 1;
}

struct ModelScene {
    Gpu& gpu = check_device();
    Scene scene;
    explicit ModelScene(const Model& model) {
        SceneFile file;
        file.objects = {object_at(ball_file, {0, 0, 0})};
        scene.load(gpu, std::move(file), [&](const auto&) { return model; });
    }
    // The first mesh at a time, as the device has deformed it.
    std::vector<Vertex> at(float time_s) {
        Frame frame(gpu);
        TestScene::begin(frame);
        animate(scene, time_s);
        scene.upload_moved(frame);
        frame.end();
        const auto bytes = gpu.read_back(scene.items[0].model->vertices[0]);
        std::vector<Vertex> vertices(bytes.size() / sizeof(Vertex));
        std::memcpy(vertices.data(), bytes.data(), bytes.size());
        return vertices;
    }
};

bool holds(const Bounds& box, glm::vec3 p) {
    const glm::vec3 slack(1e-4f);
    return glm::all(glm::greaterThanEqual(p, box.lower - slack)) && glm::all(glm::lessThanEqual(p, box.upper + slack));
}

}  // namespace

// The gradient of x² / a² + y² / b² + z² / c² is normal to the ellipsoid that the joints make of a ball.
TEST_CASE("normals of a skin under joints of unequal scale are those of the ellipsoid", "[common.joint_scale]") {
    const glm::mat4 one(1.0f), flat = glm::scale(one, {1, 0.3f, 1}), turned = glm::scale(one, {-1, 1, 1});
    const struct {
        std::vector<glm::mat4> joints;
        glm::vec4 shares;
        glm::vec3 axes;
        glm::mat4 above{1.0f};
    } cases[] = {{{flat, one}, {1, 0, 0, 0}, {1, 0.3f, 1}},
                 {{flat, one}, {0.5f, 0.5f, 0, 0}, {1, 0.65f, 1}},
                 {{turned, one}, {1, 0, 0, 0}, {1, 1, 1}},
                 {{turned * flat, one}, {1, 0, 0, 0}, {1, 0.3f, 1}},
                 {{flat, one}, {1, 0, 0, 0}, {1, 0.3f, 1}, turned},
                 {{flat, one}, {0.5f, 0.5f, 0, 0}, {1, 0.65f, 1}, turned},
                 {{turned * flat, one}, {1, 0, 0, 0}, {1, 0.3f, 1}, turned}};
    for (const auto& [joints, shares, axes, above] : cases) {
        Model model = skinned_ball(joints, shares, above);
        const auto worst = [&](const std::vector<Vertex>& vertices) {
            float most = 0;
            for (const Vertex& v : vertices)
                most = std::max(most, glm::length(v.normal - glm::normalize(v.position / (axes * axes))));
            return most;
        };
        CHECK(worst(model.meshes[0].vertices) < 1e-4f);
        set_in_motion(model);
        ModelScene test(model);
        CHECK(worst(test.at(0.5f)) < 1e-4f);
        CHECK(test.scene.items[0].mirrored == (glm::determinant(above * joints[0]) < 0));
    }
}

// A plate's normal is at right angles to both of its edges, whatever becomes of its thickness.
TEST_CASE("normals of what a node flattens are those of its plane", "[common.flattened]") {
    const glm::mat4 turned = glm::rotate(glm::mat4(1.0f), 0.7f, glm::normalize(glm::vec3(1, 2, 3)));
    for (const float size : {1e-15f, 1.0f, 1e3f})
        for (int axis = 0; axis < 3; ++axis) {
            glm::vec3 scale = size * glm::vec3(1, 2, 3), along(0.0f);
            scale[axis] = 0.0f;
            along[axis] = 1.0f;
            DrawItem item;
            item.transform = glm::scale(turned, scale);
            const glm::vec3 normal = glm::normalize(instance_of(item, 0).normal_matrix * along);
            CAPTURE(size, axis);
            CHECK(glm::length(normal - glm::vec3(turned[axis])) < 1e-5f);
        }
    DrawItem nothing;
    nothing.transform = glm::scale(turned, glm::vec3(0.0f));
    CHECK(std::isfinite(instance_of(nothing, 0).normal_matrix[0].x));
}

TEST_CASE("a morph of a mesh without normals keeps the normals of its triangles", "[common.morph_flat]") {
    Model model = test_model("quad.obj");
    Mesh& mesh = model.meshes[0];
    for (Vertex& v : mesh.vertices) v.normal = glm::vec3(0);
    Deformation& how = mesh.deformation;
    // Folds the corner at (1, 1) up to 45 degrees: the triangle (0, 1, 2) leans about the edge y = -1, (0, 2, 3) about x = -1.
    how.targets.push_back({.positions = {{0, 0, 0}, {0, 0, 0}, {0, 0, 2}, {0, 0, 0}}});
    how.weights = {1.0f};
    flatten_missing_normals(mesh);
    how.rest = mesh.vertices;
    deform_at_rest(model);
    const glm::vec3 a = glm::normalize(glm::vec3(0, -1, 1)), b = glm::normalize(glm::vec3(-1, 0, 1));
    const auto check = [&](const std::vector<Vertex>& vertices) {
        for (size_t i = 0; i < 6; ++i) CHECK(glm::length(vertices[mesh.indices[i]].normal - (i < 3 ? a : b)) < 1e-5f);
    };
    check(mesh.vertices);
    set_in_motion(model);
    ModelScene test(model);
    check(test.at(0.25f));
}

TEST_CASE("bounds hold a deformed mesh at all times, so that culling removes no visible one", "[common.moved_bounds]") {
    // A morph that moves 6 m at .5 of 8 s, between even samples of the clip.
    Model model = test_model("sphere.obj");
    Deformation& how = model.meshes[0].deformation;
    how.rest = model.meshes[0].vertices;
    how.targets.push_back({.positions = std::vector<glm::vec3>(how.rest.size(), {6, 0, 0})});
    how.weights = {0.0f};
    model.motions.push_back({.node = 0});
    model.motions[0].weights = {{0, {0.0f}}, {0.4f, {0.0f}}, {0.5f, {1.0f}}, {0.6f, {0.0f}}, {8, {0.0f}}};
    model.motions_s = 8;
    deform_at_rest(model);
    ModelScene morph(model);
    Model skin = skinned_ball({glm::mat4(1.0f), glm::mat4(1.0f)}, {0.5f, 0.5f, 0, 0});
    skin.motions.push_back({.node = skin.skins[0].joints[0]});
    skin.motions[0].position = {{0, {0, 0, 0}}, {1, {4, 0, 0}}, {3, {0, 7, 0}}};
    skin.motions[0].rotation = {{0, {1, 0, 0, 0}}, {1.5f, {0, 0, 1, 0}}, {3, {0, 1, 0, 0}}};
    skin.motions[0].scale = {{0, {1, 1, 1}}, {2, {3, 0.5f, 1}}};
    skin.motions_s = 3;
    deform_at_rest(skin);
    ModelScene skinned(skin);
    for (ModelScene* test : {&morph, &skinned})
        for (const float time_s : {0.0f, 0.37f, 0.5f, 0.55f, 1.3f, 2.2f, 2.9f, 7.9f}) {
            const std::vector<Vertex> vertices = test->at(time_s);
            const DrawItem& item = test->scene.items[0];
            CAPTURE(time_s);
            CHECK(std::all_of(vertices.begin(), vertices.end(),
                              [&](const Vertex& v) { return holds(item.bounds, v.position); }));
            // What the processor reads for rays and picking is what the device has.
            const std::vector<Vertex>& known = vertices_of(*item.model, 0);
            float most = 0;
            for (size_t i = 0; i < vertices.size(); ++i)
                most = std::max(most, glm::length(known[i].position - vertices[i].position));
            CHECK(most < 1e-5f);
        }
    CHECK(holds(model.meshes[0].bounds, {7, 0, 0}));  // the clip's own, by which a foreign model is framed
}

TEST_CASE("a deformed model stands on its ground at 0 s, as the same model at rest does", "[common.ground_below]") {
    const Model still = test_model("sphere.obj");  // from -1 to 1
    Model sinking = still;
    Deformation& how = sinking.meshes[0].deformation;
    how.rest = still.meshes[0].vertices;
    how.targets.push_back({.positions = std::vector<glm::vec3>(how.rest.size(), {0, -6, 0})});
    how.weights = {0.0f};
    sinking.motions.push_back({.node = 0});
    sinking.motions[0].weights = {{0, {0.0f}}, {1, {1.0f}}, {2, {0.0f}}};
    sinking.motions_s = 2;
    deform_at_rest(sinking);
    REQUIRE(sinking.meshes[0].bounds.lower.y < -6.9f);
    const Model below_still = ground_below(still, "ground"), below_sinking = ground_below(sinking, "ground");
    const auto& expected = below_still.meshes[0].vertices;
    CHECK(std::abs(expected[0].position.y + 1) < 0.01f);
    for (size_t i = 0; i < expected.size(); ++i)
        CHECK(below_sinking.meshes[0].vertices[i].position == expected[i].position);
    CHECK(*below_sinking.materials[0].diffuse_map.bytes == *below_still.materials[0].diffuse_map.bytes);
}
