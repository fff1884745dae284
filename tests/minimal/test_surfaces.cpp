// The minimal surfaces and tones of docs/minimal, 02 to 09, against known properties.
#include "minimal_fixture.h"

using namespace lightwalk;

TEST_CASE("02: the light that leaves the minimal surface is what its albedo says") {
    // Integrated over the hemisphere of directions to the light, the eye above the surface.
    for (const float shininess : {1.0f, 10.0f, 100.0f, 1000.0f}) {
        constexpr int rings = 2000;
        Table inputs;
        for (int i = 0; i < rings; ++i) {
            const float angle = static_cast<float>((i + 0.5) / rings * pi / 2);
            Row row = joined({{0, 0, 1}, {std::sin(angle), 0, std::cos(angle)}, {0, 0, 1}, {0.3, 0.5, 0}, {0, 0, 0.4}});
            row.push_back(shininess);
            inputs.push_back(row);
        }
        const Table found = results_of("02_lambert_phong.frag",
                                       "vec3 reflected(vec3 normal, vec3 to_light, vec3 to_eye, vec3 albedo, "
                                       "vec3 specular, float shininess)",
                                       inputs, 3);
        double sum[3] = {};
        for (int i = 0; i < rings; ++i)
            for (size_t c = 0; c < 3; ++c)
                sum[c] +=
                    found[static_cast<size_t>(i)][c] * 2 * pi * std::sin((i + 0.5) / rings * pi / 2) * pi / 2 / rings;
        CAPTURE(shininess);
        CHECK(sum[0] == Approx(0.3).epsilon(1e-3));
        CHECK(sum[1] == Approx(0.5).epsilon(1e-3));
        CHECK(sum[2] > 0.4 * 0.999);
        CHECK(sum[2] < 0.4 * 1.076);
    }
}

TEST_CASE("02: no light from behind, and the same both ways") {
    const glm::vec3 n(0, 0, 1), a = glm::normalize(glm::vec3(1, 0, 0.5)), b = glm::normalize(glm::vec3(-0.2, 0.6, 1));
    const auto row = [&](glm::vec3 light, glm::vec3 eye) {
        Row values = joined({n, light, eye, glm::vec3(0.2f), glm::vec3(0.3f)});
        values.push_back(20);
        return values;
    };
    const Table found = results_of(
        "02_lambert_phong.frag",
        "vec3 reflected(vec3 normal, vec3 to_light, vec3 to_eye, vec3 albedo, vec3 specular, float shininess)",
        {row(a, b), row(b, a), row(-a, b)}, 3);
    CHECK(found[0][0] / static_cast<double>(a.z) == Approx(found[1][0] / static_cast<double>(b.z)).epsilon(1e-4));
    CHECK(found[2][0] == 0);
}

TEST_CASE("03: the minimal light falls off as the windowed inverse square and is cut by its cone") {
    const Table falloff = results_of("03_attenuation.frag", "float distance_falloff(float distance_m, float range_m)",
                                     {{1, 100}, {2, 100}, {50, 100}, {99.9, 100}, {100, 100}, {200, 100}, {0, 100}}, 1);
    CHECK(falloff[0][0] == Approx(0.5).epsilon(1e-5));
    CHECK(falloff[1][0] == Approx(0.2).epsilon(1e-5));
    CHECK(falloff[2][0] == Approx(0.9375 * 0.9375 / 2501).epsilon(1e-5));
    CHECK(falloff[3][0] < 2e-9);
    CHECK(falloff[4][0] == 0);
    CHECK(falloff[5][0] == 0);
    CHECK(falloff[6][0] == Approx(1));
    // A lamp two metres over a floor, 8 W/sr downwards, with a cone from 0.8 to 0.9; x = 1.25 lies between the two.
    const std::string call =
        "\nvec3 lit(float x) { return irradiance(Light(vec3(0, 2, 0), 1000.0, vec3(0, -1, 0), 0.9, vec3(8), 0.8), "
        "vec3(x, 0, 0), vec3(0, 1, 0)); }\n";
    const Table lit = results_of("03_attenuation.frag", "vec3 lit(float x)", {{0}, {0.5}, {1.6}, {1.25}}, 3, "", call);
    CHECK(lit[0][0] == Approx(8.0 / 5).epsilon(1e-5));
    CHECK(lit[1][0] == Approx(8 * 2 / std::sqrt(4.25) / 5.25).epsilon(1e-5));
    CHECK(lit[2][0] == 0);
    const double cosine = 2 / std::sqrt(2 * 2 + 1.25 * 1.25);
    CHECK(lit[3][0] == Approx(8 * cosine * (cosine - 0.8) / 0.1 / (2 * 2 + 1.25 * 1.25 + 1)).epsilon(1e-4));
}

TEST_CASE("04: the minimal parallax stops where ray and height map meet") {
    const std::string map =
        "const int depth_map = 0;\n"
        "vec4 textureLod(int map, vec2 at, float lod) { return vec4(0.5 + 0.4 * sin(9.0 * at.x) * cos(7.0 * at.y)); "
        "}\n";
    Table inputs;
    Random random(4);
    for (int i = 0; i < 500; ++i)
        inputs.push_back(
            {random.uniform(0, 1), random.uniform(0, 1), random.uniform(-0.3, 0.3), random.uniform(-0.3, 0.3), 64});
    const Table found =
        results_of("04_surface_maps.frag", "float hit_depth(vec2 start, vec2 shift, int steps)", inputs, 1, map);
    for (size_t i = 0; i < inputs.size(); ++i) {
        const Row& in = inputs[i];
        const auto gap = [&](double t) {  // of the surface below the ray
            return 0.5 + 0.4 * std::sin(9 * (in[0] + t * in[2])) * std::cos(7 * (in[1] + t * in[3])) - t;
        };
        CHECK(std::fabs(gap(found[i][0])) < 1e-3);
        for (double t = 0; t < found[i][0] - 1e-3; t += 1e-3) REQUIRE(gap(t) > 0);  // the first place
    }
}

TEST_CASE("04: the minimal tangent frame follows the texture coordinates") {
    const std::string flat =
        "const int depth_map = 0;\nvec4 textureLod(int map, vec2 at, float lod) { return vec4(0); }\n";
    const std::string call =
        "\nvec3 tangent(vec2 uv_x, vec2 uv_y) {\n"
        "    return tangent_frame(vec3(0, 0, 1), vec3(0.02, 0, 0), vec3(0, 0.03, 0), uv_x, uv_y)[0];\n}\n";
    // u grows with x; u falls with y; u grows with both.
    const Table found = results_of("04_surface_maps.frag", "vec3 tangent(vec2 uv_x, vec2 uv_y)",
                                   {{0.2, 0, 0, 0.3}, {0, 0.2, -0.3, 0}, {0.2, -0.2, 0.3, 0.3}}, 3, flat, call);
    const double right[2][3] = {{1, 0, 0}, {0, -1, 0}};
    for (size_t i = 0; i < 2; ++i)  // inversesqrt may be off by 2 ulp, and a quotient by 2.5
        for (size_t c = 0; c < 3; ++c) CHECK(found[i][c] == Approx(right[i][c]).margin(1e-6));
    CHECK(found[2][0] == Approx(std::sqrt(0.5)));
    CHECK(found[2][1] == Approx(std::sqrt(0.5)));
}

TEST_CASE("09: the minimal tones, codes, lens and noise") {
    const Table toned = results_of("09_post_effects.frag", "vec3 tone(vec3 light, float white)",
                                   {{4, 4, 4, 4}, {0, 0, 0, 4}, {1e-4, 1e-4, 1e-4, 4}, {2, 1, 0, 8}}, 3);
    CHECK(toned[0][1] == Approx(1));
    CHECK(toned[1][1] == 0);
    CHECK(toned[2][1] == Approx(1e-4).epsilon(1e-3));
    CHECK(toned[3][0] == Approx(2 * toned[3][1]));
    const Table codes =
        results_of("09_post_effects.frag", "vec3 encoded(vec3 light)", {{0.214041, 0.002, 1}, {-1, 0, 9}}, 3);
    CHECK(codes[0][0] == Approx(0.5).epsilon(1e-4));
    CHECK(codes[0][1] == Approx(0.02584));
    CHECK(codes[0][2] == Approx(1));
    CHECK(codes[1][0] == 0);
    CHECK(codes[1][2] == Approx(1));
    const Table grey =
        results_of("09_post_effects.frag", "vec3 contrasted(vec3 light, float contrast)", {{0.18, 0.36, 0, 2}}, 3);
    CHECK(grey[0][0] == Approx(0.18));
    CHECK(grey[0][1] == Approx(0.72).epsilon(1e-4));
    CHECK(grey[0][2] == Approx(0).margin(1e-6));
    const Table lens = results_of("09_post_effects.frag", "float lens_falloff(float across)", {{0}, {1}}, 1);
    CHECK(lens[0][0] == 1);
    CHECK(lens[1][0] == Approx(0.25));
    Table pixels;
    for (int i = 0; i < 10000; ++i) pixels.push_back({i % 100 + 0.0, i / 100 + 0.0});
    double mean = 0, square = 0, beside = 0;
    const Table noise = results_of("09_post_effects.frag", "float noise(uvec2 pixel)", pixels, 1);
    for (size_t i = 0; i < noise.size(); ++i) {
        const double value = noise[i][0] - 0.5;
        mean += value / 1e4;
        square += value * value / 1e4;
        if (i) beside += value * (noise[i - 1][0] - 0.5) / 1e4;
    }
    CHECK(mean == Approx(0).margin(0.01));
    CHECK(square == Approx(1.0 / 12).margin(0.003));
    CHECK(beside == Approx(0).margin(0.003));
}
