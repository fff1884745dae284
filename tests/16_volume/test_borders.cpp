// Borders: of a simplex, of a moment, of a box. Both sides must meet there.
#include <fmt/core.h>

#include "volume_fixture.h"

using namespace lightwalk;

TEST_CASE_METHOD(OnVolume, "simplex noise has no steps: along lines it changes by what its slope allows") {
    Probe probe{.include = "16_volume/simplex_4d.glsl", .signature = "float simplex_4d(vec3 at, NoiseMoment moment)"};
    Random random(31);
    const size_t points = 400;
    for (int line = 0; line < 60; ++line) {
        const glm::dvec3 from(random.uniform(-9, 9), random.uniform(-9, 9), random.uniform(-9, 9));
        const glm::dvec3 along =
            glm::normalize(glm::dvec3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)));
        const NoiseMoment moment = noise_moment(random.uniform(0, 100), 5);
        for (size_t i = 0; i < points; ++i) {
            const glm::dvec3 at = from + 5e-4 * double(i) * along;
            probe.inputs.push_back({at.x, at.y, at.z, double(moment.cell), double(moment.time),
                                    double(moment.skew_cell), double(moment.skew_time), double(moment.seed)});
        }
    }
    const Table found = run_probe(gpu, probe, 1);
    double most = 0, squares = 0;
    for (size_t i = 0; i < found.size(); ++i) {
        squares += found[i][0] * found[i][0];
        if (i % points) most = std::max(most, std::fabs(found[i][0] - found[i - 1][0]));
    }
    fmt::print("simplex noise: steps of at most {:.5f} in 5e-4 of a cell, deviation {:.2f}\n", most,
               std::sqrt(squares / double(found.size())));
    CHECK(most < 0.01);  // a corner that ends at a distance of sqrt(0.6) leaves up to 0.003, at sqrt(0.7) 0.04
    CHECK(squares / double(found.size()) > 0.01);
}

TEST_CASE_METHOD(OnVolume, "noise goes on where a moment ends, by each method") {
    volume.shell.value = true;
    volume.shell_bumps.value = 0.3f;
    volume.shell_speed.value = 1;
    for (const char* noise : {"lattice", "simplex", "texture"}) {
        volume.noise.set(noise);
        const double within = mean_difference(picture(7.49f), picture(7.51f));
        const double across = mean_difference(picture(6.99f), picture(7.01f));
        fmt::print("{}: in 0.02 of a moment the picture changes by {:.6f}, where one ends by {:.6f}\n", noise, within,
                   across);
        CHECK(within > 0);
        CHECK(across < within);  // weights are level there
    }
}

TEST_CASE_METHOD(OnVolume, "a ray leaves a flat box at the face that it meets first, along each axis") {
    background = {1, 1, 1, 1};
    volume.transfer.set("even");
    volume.method.set("midpoint");
    volume.steps.value = 800;
    volume.glow.value = 0;
    volume.density.value = float(std::log(0.3) / (50 * std::log(0.8)));  // 0.3 gets through half a metre
    const struct {
        glm::ivec3 dims;
        glm::vec3 eye, up;
    } views[] = {
        {{2, 8, 8}, {3, 0, 0}, {0, 1, 0}}, {{8, 2, 8}, {0, 0, 3}, {0, 1, 0}}, {{8, 8, 2}, {0, 3, 0}, {0, 0, 1}}};
    for (const auto& view : views) {
        load(view.dims, [](int, int, int) { return 1.0f; });
        camera.position = view.eye;
        camera.up = view.up;
        INFO(view.dims.x << " x " << view.dims.y << " x " << view.dims.z);
        CHECK(double(middle().g) == Approx(0.3).epsilon(0.03));
    }
}

TEST_CASE_METHOD(OnVolume,
                 "the reference is the integral: dense matter in thousands of steps, none of them rounded away") {
    load({8, 8, 8}, [](int, int, int) { return 1.0f; });
    background = {1, 1, 1, 1};
    volume.transfer.set("even");
    volume.method.set("exact");
    volume.glow.value = 0;
    volume.density.value = float(std::log(0.3) / (200 * std::log(0.8)));  // 0.3 gets through 2 m
    for (const int samples : {4, 48, 192}) {                              // per voxel: 192 are 1,536 steps
        volume.truth_samples.value = samples;
        INFO(samples);
        CHECK(double(middle().g) == Approx(0.3).epsilon(0.004));
    }
}

TEST_CASE_METHOD(OnVolume, "the reference goes on where a tenth of the light is left") {
    load({8, 8, 8}, [](int, int, int) { return 1.0f; });
    volume.transfer.set("even");
    volume.method.set("exact");
    volume.brightest.value = 1;
    volume.density.value = float(std::log(1e-3) / (200 * std::log(0.8)));  // 0.001 gets through 2 m
    CHECK(double(middle().g) == Approx(1 - 1e-3).margin(5e-4));
}

TEST_CASE_METHOD(OnVolume, "voxels that are four times as wide as deep make a box of a quarter of the depth") {
    folder.write("flat.raw", std::string(64, '\xff'));
    const auto header = folder.write(
        "flat.volume", R"({"file": "flat.raw", "dtype": "uint8", "dims": [4, 4, 4], "spacing_mm": [8, 2, 8]})");
    scene.file.objects.push_back({.name = "volume", .parent = "", .model = header});
    owner.prepare_all(gpu, scene);
    volume.transfer.set("even");
    volume.method.set("midpoint");
    volume.steps.value = 400;
    volume.density.value = 0.05f;
    CHECK(double(middle().g) == Approx(even_light(0.5, 0.05)).epsilon(0.01));
}

TEST_CASE_METHOD(OnVolume, "a wall ends a ray where they meet, also in the picture's corner, which is farther away") {
    load({8, 8, 8}, [](int, int, int) { return 1.0f; });
    volume.transfer.set("even");
    volume.density.value = 0.03f;
    volume.steps.value = 128;
    volume.method.set("midpoint");
    wall_m = 2.15f;  // along the view: 0.15 m behind the face of the box
    const glm::dvec2 corner =
        std::tan(0.3) * glm::dvec2(double(size.x) / size.y * (1 - 1.0 / size.x), 1 - 1.0 / size.y);
    const double stretch = std::sqrt(1 + glm::dot(corner, corner));
    CHECK(stretch > 1.1);
    CHECK(double(picture().pixels[0].g) == Approx(even_light(0.15 * stretch, 0.03)).margin(0.003));
}

TEST_CASE_METHOD(OnVolume, "noise that changes along the radius alone makes no bumps on the shell") {
    Probe probe{.include = "16_volume/shell.glsl",
                .before = "#include \"../tests/16_volume/known_shell.glsl\"\n",
                .signature = "vec3 shell_over(vec3 light, vec3 position, vec3 along)",
                .truth =
                    [](auto in) {
                        return Row{0.04 * in[3], 0.04 * in[4], 0.04 * in[5]};
                    },
                .bound = {.absolute = 0.01}};
    for (const glm::dvec3 normal : {glm::dvec3(1, 0, 0), {0, 0.6, -0.8}, {-0.48, -0.6, 0.64}})
        probe.inputs.push_back({0, 0, 0, normal.x, normal.y, normal.z, -normal.x, -normal.y, -normal.z});
    CHECK(worst_of(probe, run_probe(gpu, probe, 3)) == "");
}

TEST_CASE_METHOD(OnVolume, "noise that rises by a quarter in a cell tilts a shell of height 2 by a half") {
    // The normal is (-1/2, 0, 1); the view from above is reflected to (-0.8, 0, 0.6). Schlick's share is 0.04001.
    Probe probe{.include = "16_volume/shell.glsl",
                .before = "#define EVEN_SLOPE 0.25\n#include \"../tests/16_volume/known_shell.glsl\"\n",
                .signature = "vec3 shell_over(vec3 light, vec3 position, vec3 along)",
                .inputs = {{0, 0, 0, 0, 0, 1, 0, 0, -1}},
                .truth =
                    [](auto) {
                        return Row{-0.8 * 0.04001, 0, 0.6 * 0.04001};
                    },
                .bound = {.absolute = 1e-4}};
    CHECK(worst_of(probe, run_probe(gpu, probe, 3)) == "");
}

TEST_CASE_METHOD(OnVolume, "in a white furnace the glass shell neither gains nor loses light", "[16.furnace]") {
    Probe probe{.include = "16_volume/shell.glsl",
                .before = "#define WHITE_SURROUNDINGS\n#include \"../tests/16_volume/known_shell.glsl\"\n",
                .signature = "vec3 shell_over(vec3 light, vec3 position, vec3 along)",
                .truth =
                    [](auto) {
                        return Row{1, 1, 1};
                    },
                .bound = {.absolute = 1e-5}};
    for (int i = 0; i <= 20; ++i) {  // from head on, past the limb, to a bump that faces away
        const double turn = 0.1 * i;
        probe.inputs.push_back({1, 1, 1, 0.6, 0, 0.8, -std::cos(turn) * 0.6 + std::sin(turn) * 0.8, 0,
                                -std::cos(turn) * 0.8 - std::sin(turn) * 0.6});
    }
    CHECK(worst_of(probe, run_probe(gpu, probe, 3)) == "");
}

TEST_CASE_METHOD(OnVolume, "skipping gives midpoint's picture where steps are longer than blocks, and in even matter",
                 "[16.skipping]") {
    volume.field.voxels.value = 32;
    background = {0.5f, 0.4f, 0.3f, 1};
    const auto differs = [&] {
        volume.method.set("midpoint");
        const ImageRgb right = picture();
        volume.method.set("skipping");
        return right.pixels != picture().pixels;
    };
    // Steps of 32 voxels to less than one: the first sample behind an empty block is taken, and no sample twice.
    load({64, 64, 64}, [](int x, int y, int z) { return (x / 9 + y / 11 + z / 7) % 5 == 0 ? 0.6f : 0.0f; });
    volume.transfer.set("even");
    volume.density.value = 0.05f;
    for (const int steps : {2, 3, 5, 7, 11, 19, 40, 90}) {
        volume.steps.value = steps;
        INFO(steps << " steps");
        CHECK_FALSE(differs());
    }
    // Blocks of one density: their range is a single entry of the transfer function, for 1 the last.
    volume.steps.value = 24;
    for (const float density : {1.0f, 0.0f}) {
        load({16, 16, 16}, [&](int, int, int) { return density; });
        INFO("density " << density);
        CHECK_FALSE(differs());
    }
    // Behind an empty half: the first sample there lies in such a block.
    load({64, 64, 64}, [](int, int y, int) { return y < 32 ? 1.0f : 0.0f; });
    for (const int steps : {2, 3, 4, 5, 6, 9}) {
        volume.steps.value = steps;
        INFO(steps << " steps through a half that is empty and one that is full");
        CHECK_FALSE(differs());
    }
}
