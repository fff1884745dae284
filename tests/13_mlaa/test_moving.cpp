// Motion vectors of objects against points that are moved and projected here.
#include "../common/scene_fixture.h"
#include "01_obj/camera_view.h"
#include "13_mlaa/moving.h"

using namespace lightwalk;

namespace {

/// Two quads at z = 0 and z = -2, of which the first moves; a camera that moves as well.
struct OnMoving : TestScene {
    Frame frame{gpu};
    Moving moving;
    const glm::uvec2 size{120, 80};

    static std::vector<SceneObject> objects() {
        SceneObject moves = object_at(quad_file, {0, 0, 0});
        moves.motion.spin_deg_per_s = 30;
        moves.motion.axis = {0, 0, 1};
        moves.motion.path = {{.time_s = 0, .position = {0, 0, 0}}, {.time_s = 10, .position = {5, 0, 5}}};
        return {moves, object_at(quad_file, {0, 0, -2}, glm::vec3(3.0f))};
    }
    OnMoving() : TestScene(objects()) {}

    View view(int i) const {
        Camera camera;
        camera.position = {0.05f * float(i), 0.1f, 4};
        camera.target = {0, 0, 0};
        return view_of(camera, size, {.whole = size, .shift = {0.3f, -0.2f}});
    }
    /// A frame at i/60 s, with motion vectors since the one before; false where it has none.
    bool draw(int i) {
        bool moves = false;
        frame.begin(size, float(i) / 60);
        animate(scene, float(i) / 60);
        scene.upload_moved(frame);
        const View now = view(i);
        look_from(now, frame);
        TestScene::draw(frame, scene);
        if (i > 0) moves = moving.record(frame, scene, now, view(i - 1), frame.depth);
        moving.keep(frame, scene);
        frame.end();
        return moves;
    }
};

}  // namespace

TEST_CASE("motion vectors of a quad that turns and comes nearer are those of its points") {
    OnMoving on;
    CHECK(!on.draw(0));
    REQUIRE(on.draw(1));
    REQUIRE(on.draw(2));
    const auto texels = DeviceTest::numbers<uint64_t>(on.gpu.read_back(on.moving.image()));
    const auto place = [&](const View& view, glm::dvec3 point) {  // pixels, without the shift; and w
        const glm::dvec4 clip = glm::dmat4(view.view_projection) * glm::dvec4(point, 1);
        return glm::dvec3((0.5 * glm::dvec2(clip) / clip.w + 0.5) * glm::dvec2(on.size) + glm::dvec2(view.crop.shift),
                          clip.w);
    };
    const auto moved = [](double time_s, glm::dvec2 p) {  // the scene file's motion, in double precision
        const double angle = glm::radians(30 * time_s);
        return glm::dvec3(std::cos(angle) * p.x - std::sin(angle) * p.y + 0.5 * time_s,
                          std::sin(angle) * p.x + std::cos(angle) * p.y, 0.5 * time_s);
    };
    size_t looked_at = 0;
    for (double u = -0.9; u < 1; u += 0.15)
        for (double v = -0.9; v < 1; v += 0.15) {
            const View now = on.view(2), before = on.view(1);
            const glm::dvec3 here = place(now, moved(2.0 / 60, {u, v})), there = place(before, moved(1.0 / 60, {u, v}));
            const glm::dvec2 pixel = glm::floor(glm::dvec2(here) - glm::dvec2(now.crop.shift));
            const glm::vec4 found = glm::unpackHalf4x16(texels[size_t(pixel.y) * on.size.x + size_t(pixel.x)]);
            CHECK(found.a == 1.0f);
            // A vector changes little within a pixel.
            CHECK(glm::length(glm::dvec2(found) - (glm::dvec2(there) - glm::dvec2(here))) < 0.03);
            CHECK(std::abs(double(found.z) - there.z) < 0.01);
            ++looked_at;
        }
    CHECK(looked_at > 100);
    // The quad behind does not move: it has no vectors.
    CHECK(glm::unpackHalf4x16(texels[5 * on.size.x + 5]).a == 0.0f);
}

TEST_CASE("motion vectors are drawn only when something was placed elsewhere") {
    OnMoving on;
    on.draw(0);
    on.frame.begin(on.size, 0);
    look_from(on.view(0), on.frame);
    on.TestScene::draw(on.frame, on.scene);
    CHECK(!on.moving.record(on.frame, on.scene, on.view(0), on.view(0), on.frame.depth));
    on.frame.end();
}
