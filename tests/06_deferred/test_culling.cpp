// Culling against the ids in the picture: an object that was left out wrongly is a wrong pixel.
#include <random>

#include "../common/module_fixture.h"
#include "01_obj/camera_view.h"
#include "01_obj/obj.h"
#include "06_deferred/culling.h"
#include "06_deferred/many_lights.h"

using namespace lightwalk;

namespace {

SceneObject box_at(glm::vec3 position, glm::vec3 size) {
    SceneObject object;
    object.model = "models/cube.obj";
    object.position = position;
    object.scale = size;
    return object;
}

struct OnCulling : OnModules {
    Culling culling{owner, "culling"};
    Scene scene;
    Image ids;
    Pipeline id = graphics({.vertex = "../tests/06_deferred/ids.vert", .fragment = "../tests/06_deferred/ids.frag"});

    void load(std::vector<SceneObject> objects) {
        SceneFile file;
        file.objects = std::move(objects);
        scene.load(gpu, std::move(file), [](const auto& model) { return load_model(model); });
    }

    /// The objects that the pixels show, counted from 1.
    std::vector<uint32_t> seen(const char* method, const View& view, float time_s = 0) {
        culling.method.set(method);
        begin(view.size, time_s);
        animate(scene, time_s);
        scene.upload_moved(frame);
        look_from(view, frame);
        ids.ensure(gpu.device, {.name = "ids", .format = VK_FORMAT_R32_UINT, .size = view.size});
        const std::vector<Batch> batches = scene.opaque().batches();
        bool again = false;
        culling.begin(frame, scene, view, batches);
        culling.passes(frame, frame.depth, [&] {
            frame.raster("ids",
                         {.color = {again ? keep(ids) : clear(ids, glm::vec4(0.0f))},
                          .depth = again ? keep(frame.depth) : clear(frame.depth, 0.0f),
                          .with = {culling}},
                         [&](Raster& pass) {
                             for (const Batch& batch : batches) {
                                 pass.use(id);
                                 culling.draw(pass, batch);
                             }
                         });
            again = true;
        });
        frame.end();
        return read<uint32_t>(ids);
    }

    static View look(glm::vec3 from, glm::vec3 to, glm::uvec2 size = {64, 36}, float near_m = 0.1f) {
        Camera camera;
        camera.position = from;
        camera.target = to;
        camera.near_m = near_m;
        camera.far_m = 500;
        return view_of(camera, size, {.whole = size});
    }
};

size_t different(const std::vector<uint32_t>& a, const std::vector<uint32_t>& b) {
    REQUIRE(a.size() == b.size());
    size_t count = 0;
    for (size_t i = 0; i < a.size(); ++i) count += a[i] != b[i];
    return count;
}

}  // namespace

// A walk along a street with turns of the head, cuts, flights over the roofs, and stands within walls.
TEST_CASE_METHOD(OnCulling, "no pixel of 200 cameras in a town loses its object", "[06.culled]") {
    std::vector<SceneObject> town = town_objects(800);
    SceneObject gate = box_at({0, 4, 0}, {12, 8, 0.4f});  // hides the street, and moves aside
    gate.motion.path = {{.time_s = 0, .position = {0, 4, 0}},
                        {.time_s = 4, .position = {0, 4, 0}},
                        {.time_s = 5, .position = {0, 14, 0}},
                        {.time_s = 9, .position = {0, 4, 0}}};
    town.push_back(gate);
    load(std::move(town));
    size_t wrong = 0, tested = 0, drawn[3] = {};
    for (int k = 0; k < 200; ++k) {
        const float s = float(k), time_s = 0.05f * s;
        glm::vec3 from(1.5f * std::sin(0.7f * s), 1.7f, 30.0f - 0.25f * s);
        glm::vec3 to = from + glm::vec3(std::sin(0.1f * s), 0.2f * std::sin(0.3f * s), -std::cos(0.1f * s));
        if (k % 20 >= 15) {
            from = {40.0f * std::sin(s), 3.0f + 0.1f * s, 40.0f * std::cos(s)};  // cuts
            to = {0, 2, 0};
        }
        if (k % 20 == 14) from.x = 6.0f;  // the near plane cuts a wall
        const glm::uvec2 size = k < 150 ? glm::uvec2(63, 37) : glm::uvec2(50, 31);
        const View view = look(from, to, size, k % 3 ? 0.1f : 1.0f);
        const std::vector<uint32_t> truth = seen("none", view, time_s);
        culling.bounds.set(k % 2 ? "box" : "sphere");
        const char* const methods[] = {"frustum_cpu", "frustum_gpu", "occlusion"};
        for (int m = k % 2; m < 3; m += m == 0 ? 2 : 1) {
            INFO("camera " << k << ", " << methods[m]);
            const size_t lost = different(truth, seen(methods[m], view, time_s));
            CHECK(lost == 0);
            wrong += lost;
            drawn[m] += culling.drawn();
        }
        tested += culling.tested();
    }
    CHECK(wrong == 0);
    // It is of use: hidden objects are a good part of those within the view.
    CHECK(drawn[2] * 2 < tested);
    CHECK(drawn[2] * 4 < 3 * (drawn[0] + drawn[1]));
}

TEST_CASE_METHOD(OnCulling, "walls beside the camera, boxes larger than the picture, and one pixel", "[06.culled]") {
    load({box_at({-1.0f, 0, -20}, {0.5f, 4, 60}),      // from behind the camera to far away
          box_at({0.6f, 0, -10}, {0.2f, 1.5f, 0.2f}),  // before its far end
          box_at({0, 0, -30}, {100, 100, 0.5f}),       // all that can be seen
          box_at({0, 0, -40}, {5, 5, 5}),              // hidden
          box_at({0, 0, 50}, {5, 5, 5}),               // behind
          box_at({0, -3, 0}, {50, 1, 50})});           // under the feet
    for (const glm::uvec2 size : {glm::uvec2(33, 17), {1, 1}, {1, 9}, {2, 64}, {127, 3}}) {
        INFO(size.x << "x" << size.y);
        for (const float turn : {0.0f, 0.02f, -0.3f, 1.6f, 3.1f}) {
            const View view = look({0, 0, 5}, {5 * std::sin(turn), 0, 5 - 5 * std::cos(turn)}, size);
            const auto truth = seen("none", view);
            for (int frame_number = 0; frame_number < 3; ++frame_number)
                CHECK(different(truth, seen("occlusion", view)) == 0);
        }
    }
    const View ahead = look({0, 0, 5}, {0, 0, 0}, {33, 17});
    seen("occlusion", ahead);
    seen("occlusion", ahead);
    CHECK(culling.drawn() == 4);
    CHECK(culling.tested() == 6);
    seen("frustum_gpu", ahead);
    CHECK(culling.drawn() == 5);
    seen("frustum_cpu", ahead);
    CHECK(culling.drawn() == 5);
}

TEST_CASE("planes of a view without a far plane leave out nothing far away", "[06.culled]") {
    glm::mat4 endless(0.0f);  // reversed depth: near / distance
    endless[0][0] = endless[1][1] = 1.0f;
    endless[2][3] = -1.0f;
    endless[3][2] = 0.1f;
    for (const glm::vec4& plane : view_planes(endless, 0.0f)) CHECK(glm::dot(plane, glm::vec4(0, 0, -1e6f, 1)) >= 0.0f);
    CHECK(glm::dot(view_planes(endless, 0.0f)[5], glm::vec4(0, 0, -0.09f, 1)) < 0.0f);  // nearer than the near plane
}

TEST_CASE_METHOD(OnCulling, "a texel of the depth pyramid is the farthest of all pixels that it covers",
                 "[06.culled]") {
    DepthPyramid pyramid("pyramid");
    std::mt19937 random(7);
    for (const glm::uvec2 size : {glm::uvec2(1, 1), {1, 70}, {63, 37}, {64, 64}, {127, 95}, {129, 66}, {1090, 33}}) {
        std::vector<float> depths(size_t(size.x) * size.y);
        for (float& depth : depths) depth = float(random() % 65536) / 65536;
        Image depth;
        depth.ensure(gpu.device, {.name = "depth", .format = VK_FORMAT_R32_SFLOAT, .size = size});
        begin({4, 4});
        frame.upload("depth", depth, std::as_bytes(std::span(depths)));
        pyramid.record(frame, depth);
        frame.end();
        const ImageView all(pyramid.image());
        for (int m = 0; m < pyramid.levels(); ++m) {
            // Of each direction: as many texels as whole steps of 2^(m+1) pixels, and the last one has the rest.
            const uint32_t step = 2u << m;
            const glm::uvec2 texels = glm::max(size / step, 1u);
            const std::vector<float> found = read<float>(all.mip(uint32_t(m)));
            REQUIRE(found.size() == size_t(texels.x) * texels.y);
            std::vector<float> right(found.size(), 1.0f);
            for (uint32_t y = 0; y < size.y; ++y)
                for (uint32_t x = 0; x < size.x; ++x) {
                    const glm::uvec2 at = glm::min(glm::uvec2(x, y) / step, texels - 1u);
                    float& farthest = right[size_t(at.y) * texels.x + at.x];
                    farthest = std::min(farthest, depths[size_t(y) * size.x + x]);
                }
            INFO(size.x << "x" << size.y << ", mip " << m);
            CHECK(found == right);
        }
        CHECK(glm::uvec2(all.mip(uint32_t(pyramid.levels() - 1)).size()) == glm::uvec2(1));
    }
}
