// Terrain of an edited scene: it comes and goes in one step, leaves pictures of before alone, and things land on it.
#include "18_playground/commands.h"
#include "18_playground/editor_part.h"
#include "common/check/probe.h"
#include "driven_editor.h"

using namespace lightwalk;

namespace {

// A plane y = 3 + 0.5 x - 0.25 z, 64 samples of 2 m.
GroundHeights sloped_ground() {
    GroundHeights ground{{.corner = {-63, -63}, .spacing_m = 2, .samples = 64}, {}};
    for (int z = 0; z < 64; ++z)
        for (int x = 0; x < 64; ++x)
            ground.heights_m.push_back(3 + 0.5f * float(2 * x - 63) - 0.25f * float(2 * z - 63));
    return ground;
}

const char* const terrain = "terrain/jacksboro_dem.png";

}  // namespace

TEST_CASE("a ray meets sloping ground where a plane's equation says, from above alone", "[terrain]") {
    const GroundHeights ground = sloped_ground();
    Random random(18);
    for (int i = 0; i < 200; ++i) {
        const glm::dvec3 from(random.uniform(-20, 20), 60, random.uniform(-20, 20));
        const glm::dvec3 direction =
            glm::normalize(glm::dvec3(random.uniform(-0.4, 0.4), -1, random.uniform(-0.4, 0.4)));
        // (from + t direction) lies in the plane.
        const double t =
            (3 + 0.5 * from.x - 0.25 * from.z - from.y) / (direction.y - 0.5 * direction.x + 0.25 * direction.z);
        const auto met = ground.met_by({glm::vec3(from), glm::vec3(direction)}, 1000);
        REQUIRE(met);
        CHECK(double(met->distance_m) == Approx(t).margin(1e-3));
        CHECK(glm::length(met->normal - glm::normalize(glm::vec3(-0.5f, 1, 0.25f))) < 1e-3f);
    }
    CHECK(!ground.met_by({{0, 60, 0}, {0, 1, 0}}, 1000));
    CHECK(!ground.met_by({{0, -60, 0}, {0, 1, 0}}, 1000));
    CHECK(!ground.met_by({{0, 60, 0}, {0, -1, 0}}, 50));
    CHECK(!ground.met_by({{200, 60, 0}, {0, -1, 0}}, 1000));
}

TEST_CASE("terrain comes and goes in steps; without it the picture is as before, to the byte", "[terrain]") {
    Driven editor;
    const std::vector<std::byte> before = editor.picture();
    set_terrain(editor.document(), terrain, 5e4f, 7);
    editor.window.bench.air.set("sky");
    editor.window.editor.gesture = 7;  // as one click has it
    const std::vector<std::byte> with = editor.picture();
    CHECK(editor.window.bench.ground.exists());
    CHECK(with != before);
    CHECK(editor.document().settings().camera.far_m == 5e4f);
    CHECK(terrain_of(editor.document()) == editor.named("ground"));
    CHECK(editor.document().done() == 1);

    // It has no place of its own: nothing to drag.
    editor.window.editor.selection.set({terrain_of(editor.document())});
    editor.draw();
    CHECK(!gizmo_place(editor.document(), editor.window.editor.selection, editor.window.view_now, Tool::move, false));
    editor.window.editor.selection.clear();

    set_hidden(editor.document(), {terrain_of(editor.document())}, true);
    editor.draw();
    CHECK(!editor.window.bench.ground.exists());
    while (editor.document().done() > 0) editor.window.editor.undo(editor.window);
    CHECK(editor.picture() == before);
    CHECK(!editor.window.bench.ground.exists());
    editor.window.editor.go_to(editor.window, 1);
    CHECK(editor.picture() == with);
}

TEST_CASE("things land on the terrain that a pixel shows", "[terrain]") {
    Driven editor(R"({"camera": {"position": [0, 600, 0], "target": [2000, 0, 2000], "far_m": 50000},
        "objects": [{"name": "ground", "model": "terrain/jacksboro_dem.png"}],
        "knobs": {"air": "sky", "ground.levels": 8, "ground.datum_m": 300}})");
    const GroundHeights ground = read_heights(editor.gpu, editor.window.bench.ground);
    REQUIRE(ground.heights_m.size() == 257 * 257);
    const PickRay ray = ray_through(editor.window.view_now, {80, 100});
    const Landing landing = landing_on(editor.window.scene, editor.window.camera, ray, ground);
    // As far along the view as the picture's own ground.
    const std::vector<std::byte> found = editor.gpu.read_back(editor.window.bench.land.found());
    float along = 0;
    std::memcpy(&along, found.data() + sizeof(float) * (100 * 160 + 80), sizeof(float));
    REQUIRE(along > 0);
    const float cosine =
        glm::dot(ray.direction, glm::normalize(editor.window.camera.target - editor.window.camera.position));
    CHECK(landing.distance_m * cosine == Approx(along).epsilon(0.02));
    CHECK(std::fabs(landing.point.y - *ground.height_at({landing.point.x, landing.point.z})) < 0.05f);
    CHECK(landing.normal.y > 0.3f);
}

TEST_CASE("knobs of a first terrain put its middle at the scene's floor", "[terrain]") {
    const HeightMap map{.width = 3, .height = 3, .sample_m = {30, 20}, .elevation_m = {1, 2, 3, 4, 555, 6, 7, 8, 9}};
    CHECK(side_m(map) == 40);
    Bounds scene;
    scene.add(glm::vec3(-1, 5, -1));
    scene.add(glm::vec3(1, 7, 1));
    const auto knobs = terrain_knobs(map, scene);
    CHECK(knobs.at("air") == "sky");
    CHECK(std::stof(knobs.at("ground.plain_m")) == Approx(5).margin(0.02));
    CHECK(std::stof(knobs.at("ground.plain_m")) < 5);
    CHECK(std::stof(knobs.at("ground.datum_m")) == Approx(550).margin(1));
    CHECK(std::stof(knobs.at("ground.plain_km").substr(4)) > 1e-3f * std::sqrt(3.0f));  // all of the scene stands on it
}
