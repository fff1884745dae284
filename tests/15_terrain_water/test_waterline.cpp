// Water around objects that stand in it: distances against closed forms, the speed of ring waves, and where there are none.
#include <cmath>

#include "../common/module_fixture.h"
#include "01_obj/obj.h"
#include "15_terrain_water/water.h"
#include "common/scene/scene.h"

using namespace lightwalk;

namespace {

SceneObject standing(const char* model, const glm::vec3& position, const glm::vec3& scale = glm::vec3(1.0f),
                     float turned_deg = 0) {
    SceneObject object;
    object.name = model;
    object.model = std::string("models/") + model;
    object.position = position;
    object.scale = scale;
    object.rotation_deg = {0, turned_deg, 0};
    return object;
}

struct InWater : OnModules {
    Waterline line{owner, "waterline"};
    Scene scene;
    std::vector<float> to_line;

    InWater() {
        line.method.set("rings");
        line.texels.value = 256;
    }

    void record(std::vector<SceneObject> objects, float time_s = 0, float level_m = 0) {
        scene.load(gpu, {.objects = std::move(objects)}, [](const auto& file) { return load_model(file); });
        owner.prepare_all(gpu, scene);
        begin({16, 16}, time_s);
        line.record(frame, scene, level_m, {1, 0});
        frame.end();
        to_line = line.exists() ? read<float>(line.distances().mip(0)) : std::vector<float>();
    }

    /// The largest error of a distance, in texels, where the truth is below the map's reach.
    double error_texels(const std::function<double(glm::dvec2)>& truth) const {
        const WaterlineMap& map = line.map();
        const int side = line.texels;
        const double texel_m = double(map.side_m) / side, most_m = texel_m * (map.most_texels - 2);
        double largest = 0;
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x) {
                const double right = truth(glm::dvec2(map.corner) + texel_m * (glm::dvec2(x, y) + 0.5));
                const double found = double(to_line[size_t(y) * size_t(side) + size_t(x)]);
                if (right < most_m) largest = std::max(largest, std::fabs(found - right) / texel_m);
            }
        return largest;
    }
};

}  // namespace

TEST_CASE_METHOD(InWater, "the distance to a ball that the water cuts is that to a circle", "[waterline]") {
    // Radius 0.5, its middle 0.3 below the water: Pythagoras leaves 0.4.
    record({standing("sphere.obj", {1, -0.3f, 2})});
    const auto circle = [](glm::dvec2 at) { return std::max(glm::length(at - glm::dvec2(1, 2)) - 0.4, 0.0); };
    CHECK(error_texels(circle) < 1.3);
}

TEST_CASE_METHOD(InWater, "a turned beam, and a ball inside of another one, are solid", "[waterline]") {
    record({standing("cube.obj", {0, 0.4f, 0}, {1.2f, 2, 0.4f}, 30)});
    const double angle = 30 * M_PI / 180;
    const auto beam = [&](glm::dvec2 at) {
        // Turned back about y: x to the east, z to the south.
        const glm::dvec2 own(std::cos(angle) * at.x - std::sin(angle) * at.y,
                             std::sin(angle) * at.x + std::cos(angle) * at.y);
        return glm::length(glm::max(glm::abs(own) - glm::dvec2(0.6, 0.2), 0.0));
    };
    CHECK(error_texels(beam) < 1.3);
    record({standing("sphere.obj", {0, 0, 0}), standing("sphere.obj", {0, 0, 0}, glm::vec3(0.5f))});
    CHECK(error_texels([](glm::dvec2 at) { return std::max(glm::length(at) - 0.5, 0.0); }) < 1.3);
}

TEST_CASE_METHOD(InWater, "what is above the water or below it makes no rings", "[waterline]") {
    record({standing("sphere.obj", {0, 0.7f, 0}), standing("cube.obj", {2, -3, 0})});
    CHECK(!line.exists());
    record({standing("sphere.obj", {0, 0.7f, 0}), standing("cube.obj", {2, 0, 0})});
    CHECK(line.exists());
    CHECK(error_texels(
              [](glm::dvec2 at) { return glm::length(glm::max(glm::abs(at - glm::dvec2(2, 0)) - 0.5, 0.0)); }) < 1.3);
    line.method.set("none");
    record({standing("cube.obj", {2, 0, 0})});
    CHECK(!line.exists());
}

TEST_CASE_METHOD(InWater, "the slowest ring waves are 17 mm long and run at 0.231 m/s", "[waterline]") {
    // The minimum of the phase speed on clean water: H. Lamb, Hydrodynamics, 1932, article 267.
    line.length_m.value = 0.0171f;
    const double time_s = 3;
    record({standing("cube.obj", {0, 0, 0})}, float(time_s));
    const double turns = 0.231 * time_s / 0.0171;  // wavelengths
    CHECK(std::remainder(double(line.map().phase.x) / (2 * M_PI) - turns, 1.0) == Approx(0).margin(0.01 * turns));
    for (const double length : {0.012, 0.025}) {
        const double k = 2 * M_PI / length;
        CHECK(std::sqrt(9.81 / k + 7.4e-5 * k) > 0.231);
    }
}
