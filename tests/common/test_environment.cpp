// The environment's cubes against sums in double precision.

#include "common/app/environment.h"
#include "common/image/image.h"
#include "common/scene/scene_file.h"
#include "file_fixture.h"
#include "module_fixture.h"

using namespace lightwalk;

namespace {

constexpr double pi = 3.14159265358979323846;

glm::dvec3 direction_of(double u, double v) {
    const double phi = (2 * u - 1) * pi, theta = v * pi;
    return {std::sin(phi) * std::sin(theta), std::cos(theta), -std::cos(phi) * std::sin(theta)};
}

/// For each normal the sum over every texel, with its solid angle.
std::vector<glm::dvec3> irradiance(const ImageRgb& picture, const std::vector<glm::vec3>& normals) {
    std::vector<glm::dvec3> sums(normals.size(), glm::dvec3(0));
    const double high = pi / picture.height;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            const glm::dvec3 to_light = direction_of((x + 0.5) / picture.width, (y + 0.5) / picture.height);
            const double solid_angle = 2 * pi / picture.width * (std::cos(y * high) - std::cos((y + 1) * high));
            const glm::dvec3 light = solid_angle * glm::dvec3(picture.at(x, y));
            for (size_t i = 0; i < normals.size(); ++i)
                sums[i] += light * std::max(0.0, glm::dot(glm::dvec3(normals[i]), to_light));
        }
    return sums;
}

struct OnEnvironment : OnModules {
    EnvironmentLight environment{owner, "environment"};
    Scene scene;
    Pipeline read_both = compute_pipeline("read environment", R"(
#include "common/environment.glsl"
layout(local_size_x = 64) in;
layout(scalar) readonly buffer DirectionBuffer { vec3 directions[]; };
layout(scalar) writeonly buffer FoundBuffer { vec3 found[]; };
void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= uint(directions.length())) return;
    found[2u * i] = environment_radiance(directions[i], 0.0);
    found[2u * i + 1u] = environment_irradiance(directions[i]);
})");

    OnEnvironment() { begin({4, 4}); }

    void load(const std::string& image) {
        SceneFile file;
        file.ambient = {0.25f, 0.5f, 2.0f};
        if (!image.empty()) file.environment.image = image;
        scene.load(gpu, file, [](const auto&) -> Model { return {}; });
        owner.begin_frame(gpu, {4, 4});
        environment.record(frame, scene);
    }

    /// Radiance and irradiance, in turn.
    std::vector<glm::vec3> found(const std::vector<glm::vec3>& directions) {
        const Buffer in = gpu.upload("directions", directions);
        const Buffer out(gpu.device, {.name = "found", .bytes = 24 * directions.size()});
        frame.compute("read", {.reads = {in}, .writes = {out}, .with = {environment}}, [&](Compute& pass) {
            pass.use(read_both).set("directions", in).set("found", out);
            pass.dispatch_threads(glm::uvec2(static_cast<uint32_t>(directions.size()), 1));
        });
        frame.end();
        const auto numbers = read<glm::vec3>(out);
        frame.begin({4, 4}, 0);
        return numbers;
    }
};

std::vector<glm::vec3> all_around() {
    std::vector<glm::vec3> directions{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    for (int i = 0; i < 60; ++i) {
        const double y = 1 - (2 * i + 1) / 60.0, turn = 2.399963 * i;
        directions.push_back(glm::dvec3(std::sqrt(1 - y * y) * glm::dvec2(std::cos(turn), std::sin(turn)), y));
    }
    return directions;
}

}  // namespace

TEST_CASE_METHOD(OnEnvironment, "an even environment: its radiance everywhere, and pi times that on every surface") {
    load("");
    environment.intensity.value = 2;
    const auto directions = all_around();
    const auto light = found(directions);
    for (size_t i = 0; i < directions.size(); ++i)
        for (int c = 0; c < 3; ++c) {
            const double even = 2.0 * double(scene.file.ambient[c]);
            CHECK(double(light[2 * i][c]) == Approx(even).epsilon(1e-3));
            CHECK(double(light[2 * i + 1][c]) == Approx(pi * even).epsilon(2e-3));
        }
}

TEST_CASE_METHOD(OnEnvironment, "irradiance of photographed places, lamps of 15,000 among them, within 1.5%") {
    for (const std::string name : {"interior", "studio"}) {
        load("environments/" + name + ".hdr");
        const ImageRgb picture = read_radiance(find_asset("environments/" + name + ".hdr"));
        const auto directions = all_around();
        const auto found_light = found(directions);
        const std::vector<glm::dvec3> right = irradiance(picture, directions);
        glm::dvec3 most(0);
        for (const glm::dvec3& light : right) most = glm::max(most, light);
        double worst = 0;
        for (size_t i = 0; i < directions.size(); ++i)
            worst = std::max(worst, glm::length((glm::dvec3(found_light[2 * i + 1]) - right[i]) / most));
        INFO(name);
        CHECK(worst < 0.015);
    }
}

TEST_CASE_METHOD(OnEnvironment,
                 "where things are: the picture's middle is -z, its right quarter +x; a turn is about +y") {
    const FileFolder folder;
    const auto file = folder / "directions.pfm";
    ImageRgb picture(64, 32);
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 64; ++x)
            picture.at(x, y) = glm::vec3(direction_of((x + 0.5) / 64, (y + 0.5) / 32)) * 0.5f + 0.5f;
    write_pfm(file, picture);
    load(file.string());
    const auto directions = all_around();
    for (const float turn : {0.0f, 90.0f, -37.0f}) {
        environment.turn_deg.value = turn;
        const auto light = found(directions);
        const double a = glm::radians(double(turn));
        for (size_t i = 0; i < directions.size(); ++i) {
            const glm::dvec3 seen = 2.0 * glm::dvec3(light[2 * i]) - 1.0;  // the direction in the picture
            const glm::dvec3 turned{std::cos(a) * seen.x + std::sin(a) * seen.z, seen.y,
                                    std::cos(a) * seen.z - std::sin(a) * seen.x};
            INFO(turn << " " << i);
            CHECK(glm::length(turned - glm::dvec3(directions[i])) < 0.02);  // a spline flattens a little
        }
    }
}
