// The minimal skies, grounds, volumes, waters and planets of docs/minimal against known properties.
#include "minimal_fixture.h"

using namespace lightwalk;

namespace {

// The same sky in double precision with fine steps: from the sun's direction, the ray's and the eye's height in km.
struct Sky {
    static constexpr double radius = 6360;
    static glm::dvec3 amounts(double height) {
        return {std::exp(-height / 8), std::exp(-height / 1.2), std::fmax(1 - std::fabs(height - 25) / 15, 0.0)};
    }
    static glm::dvec3 extinction(glm::dvec3 amount) {
        return glm::dvec3(5.802e-3, 13.558e-3, 33.1e-3) * amount.x + 4.44e-3 * amount.y +
               glm::dvec3(0.65e-3, 1.881e-3, 0.085e-3) * amount.z;
    }
    /// Calls `take` in the middle of each of many short steps, until the ray leaves the air (false) or meets the ground.
    template <class Take>
    static bool walk(glm::dvec3 from, glm::dvec3 along, double step_km, Take take) {
        for (double t = step_km / 2;; t += step_km) {
            const glm::dvec3 place = from + t * along;
            const double height = glm::length(place) - radius;
            if (height < 0) return true;
            if (height > 100) return false;
            take(place, height);
        }
    }
    static glm::dvec3 radiance(glm::dvec3 sun, glm::dvec3 along, double eye_km) {
        const double c = glm::dot(sun, along), molecules = 3 / (16 * pi) * (1 + c * c);
        const double dust = 1 / (4 * pi) * 0.36 / std::pow(1.64 - 1.6 * c, 1.5);
        glm::dvec3 light(0), depth(0);
        walk({0, radius + eye_km, 0}, along, 0.5, [&](glm::dvec3 place, double height) {
            const glm::dvec3 amount = amounts(height), taken = 0.5 * extinction(amount);
            glm::dvec3 to_sun(0);
            const bool dark =
                walk(place, sun, 0.5, [&](glm::dvec3, double above) { to_sun += 0.5 * extinction(amounts(above)); });
            const glm::dvec3 scattered =
                glm::dvec3(5.802e-3, 13.558e-3, 33.1e-3) * amount.x * molecules + 3.996e-3 * amount.y * dust;
            if (!dark) light += 0.5 * scattered * glm::exp(-to_sun - depth - 0.5 * taken);
            depth += taken;
        });
        return light;
    }
};

}  // namespace

TEST_CASE("10: the minimal sky is that of fine steps in double precision") {
    Table inputs;
    for (const double sun_deg : {60.0, 20.0, 2.0})
        for (const double ray_deg : {90.0, 30.0, 4.0, 150.0}) {
            const double s = sun_deg * pi / 180, r = ray_deg * pi / 180;
            Row row{0.2};
            append(row, glm::vec3(std::cos(r), std::sin(r), 0));
            append(row, glm::vec3(std::cos(s), std::sin(s), 0));
            row.push_back(32);
            inputs.push_back(row);
        }
    const Table found =
        results_of("10_atmosphere.frag", "vec3 sky(float eye_height, vec3 direction, vec3 sun, int steps)", inputs, 3);
    for (size_t i = 0; i < inputs.size(); ++i) {
        const Row& in = inputs[i];
        const glm::dvec3 exact = Sky::radiance({in[4], in[5], in[6]}, {in[1], in[2], in[3]}, in[0]);
        CAPTURE(i, found[i], exact.x, exact.y, exact.z);
        for (int c = 0; c < 3; ++c)
            CHECK(found[i][static_cast<size_t>(c)] == Approx(exact[c]).epsilon(0.05).margin(1e-4));
    }
    CHECK(found[0][2] > 2 * found[0][0]);  // blue at noon
    CHECK(found[10][0] > found[10][2]);    // red at the horizon, below the low sun
}

TEST_CASE("11: the minimal ray stops on the ground, and has not passed any before") {
    Table inputs, heights;
    Random random(11);
    for (int i = 0; i < 200; ++i)
        inputs.push_back({random.uniform(-5e3, 5e3), 901, random.uniform(-5e3, 5e3), random.uniform(-1, 1), -0.2,
                          random.uniform(-1, 1), 20000, 6});
    for (Row& row : inputs) {
        const double length = std::sqrt(row[3] * row[3] + row[4] * row[4] + row[5] * row[5]);
        for (size_t k = 3; k < 6; ++k) row[k] = static_cast<double>(static_cast<float>(row[k] / length));
    }
    const Table found =
        results_of("11a_landscape.frag", "float march(vec3 origin, vec3 direction, float far, int octaves)", inputs, 1);
    constexpr int parts = 500;
    for (size_t i = 0; i < inputs.size(); ++i)
        for (int k = 1; k <= parts; ++k) {
            const double t = found[i][0] * k / parts;
            heights.push_back({inputs[i][0] + t * inputs[i][3], inputs[i][2] + t * inputs[i][5], 6});
        }
    const Table ground = results_of("11a_landscape.frag", "float ground(vec2 at, int octaves)", heights, 1);
    int passed = 0;
    for (size_t i = 0; i < inputs.size(); ++i) {
        REQUIRE(found[i][0] < 20000);  // a ray that goes down ends
        for (int k = 1; k <= parts; ++k) {
            const double t = found[i][0] * k / parts,
                         above = inputs[i][1] + t * inputs[i][4] - ground[i * parts + static_cast<size_t>(k) - 1][0];
            if (k == parts)
                CHECK(std::fabs(above) < 0.002 * t);
            else if (above < -0.002 * t)
                ++passed;
        }
    }
    CHECK(passed == 0);
}

TEST_CASE("16: the minimal volume hides what Beer and Lambert say, and meets its box") {
    const std::string even =
        "const int densities = 0;\nvec4 textureLod(int map, vec3 at, float lod) { return vec4(0.5); }\n";
    const std::string ramp =
        "const int densities = 0;\nvec4 textureLod(int map, vec3 at, float lod) { return vec4(at.x); }\n";
    const std::string signature = "vec4 march(vec3 origin, vec3 direction, int samples)";
    const double slant = std::sqrt(0.5);
    const Table found = results_of("16_volume.frag", signature,
                                   {{-3, 0, 0, 1, 0, 0, 7},
                                    {0, 0, 0, 0, 1, 0, 7},
                                    {-3, 2, 0, 1, 0, 0, 7},
                                    {3, 0, 0, 1, 0, 0, 7},
                                    {-2, -2, 0.5, slant, slant, 0, 7}},
                                   4, even);
    const double extinction = 6 * 0.25;
    CHECK(found[0][3] == Approx(1 - std::exp(-2 * extinction)).epsilon(1e-5));
    CHECK(found[0][0] == Approx(0.8 * found[0][3]).epsilon(1e-5));
    CHECK(found[1][3] == Approx(1 - std::exp(-extinction)).epsilon(1e-5));
    CHECK(found[2][3] == 0);
    CHECK(found[3][3] == 0);
    CHECK(found[4][3] == Approx(1 - std::exp(-std::sqrt(8.0) * extinction)).epsilon(1e-5));
    // A density that grows along the ray, against fine steps in double precision.
    const Table grows = results_of("16_volume.frag", signature, {{-3, 0, 0, 1, 0, 0, 64}}, 4, ramp);
    double depth = 0, green = 0;
    for (int i = 0; i < 100000; ++i) {
        const double density = (i + 0.5) / 1e5, part = 6 * density * density * 2e-5;
        green += (0.1 + 0.7 * density) * std::exp(-depth) * part;
        depth += part;
    }
    CHECK(grows[0][1] == Approx(green).epsilon(2e-3));
    CHECK(grows[0][3] == Approx(1 - std::exp(-depth)).epsilon(1e-3));
}

namespace {

// A column of the minimal water's slopes, and the place.
const std::string water_call =
    "\nvec3 place_of(float x, float z, float t) { mat2x3 slopes; return moved(vec2(x, z), t, slopes); }\n"
    "vec3 normal_of(float x, float z, float t) {\n"
    "    mat2x3 slopes;\n    moved(vec2(x, z), t, slopes);\n    return normalize(cross(slopes[1], slopes[0]));\n}\n";

// The same four waves in double precision.
glm::dvec3 water_at(double x, double z, double time) {
    const double waves[4][4] = {
        {0.5, 0.2, 0.3, 0.5}, {-0.4, 0.9, 0.16, 0.5}, {1.5, 1.1, 0.08, 0.6}, {2.9, -1.3, 0.04, 0.6}};
    glm::dvec3 place(x, 0, z);
    for (const auto& w : waves) {
        const double k = std::hypot(w[0], w[1]), phase = w[0] * x + w[1] * z - std::sqrt(9.81 * k) * time;
        place.x += w[2] * w[3] * w[0] / k * std::cos(phase);
        place.z += w[2] * w[3] * w[1] / k * std::cos(phase);
        place.y += w[2] * std::sin(phase);
    }
    return place;
}

}  // namespace

TEST_CASE("15: the minimal water lies where Gerstner's waves move it, and its normals are the surface's") {
    Table inputs;
    Random random(15);
    for (int i = 0; i < 300; ++i)
        inputs.push_back({random.uniform(-20, 20), random.uniform(-20, 20), random.uniform(0, 10)});
    const Table places = results_of("15_terrain_water.frag", "vec3 place_of(float x, float z, float t)", inputs, 3,
                                    "const vec4 to_sun = vec4(0, 1, 0, 0);\n", water_call);
    const Table normals = results_of("15_terrain_water.frag", "vec3 normal_of(float x, float z, float t)", inputs, 3,
                                     "const vec4 to_sun = vec4(0, 1, 0, 0);\n", water_call);
    for (size_t i = 0; i < inputs.size(); ++i) {
        const Row& in = inputs[i];
        const double x = double(float(in[0])), z = double(float(in[1])), t = double(float(in[2])), h = 1e-4;
        const glm::dvec3 place = water_at(x, z, t);
        const glm::dvec3 along_x = water_at(x + h, z, t) - water_at(x - h, z, t),
                         along_z = water_at(x, z + h, t) - water_at(x, z - h, t);
        const glm::dvec3 normal = glm::normalize(glm::cross(along_z, along_x));
        for (int c = 0; c < 3; ++c) {
            CHECK(places[i][size_t(c)] == Approx(place[c]).margin(2e-4));
            CHECK(normals[i][size_t(c)] == Approx(normal[c]).margin(5e-4));
        }
    }
}

TEST_CASE("15: rays meet the minimal water, which reflects and absorbs as measured") {
    const std::string sun = "const vec4 to_sun = vec4(0, 1, 0, 0);\n";
    Table inputs;
    Random random(16);
    for (int i = 0; i < 200; ++i) {
        const glm::vec3 d =
            glm::normalize(glm::vec3(random.uniform(-1, 1), random.uniform(-1, -0.4), random.uniform(-1, 1)));
        Row row{random.uniform(-9, 9), random.uniform(2, 8), random.uniform(-9, 9)};
        append(row, d);
        row.push_back(random.uniform(0, 10));
        inputs.push_back(row);
    }
    const Table found =
        results_of("15_terrain_water.frag", "vec2 met(vec3 from, vec3 direction, float time)", inputs, 2, sun);
    for (size_t i = 0; i < inputs.size(); ++i) {
        const Row& in = inputs[i];
        const glm::dvec3 from(in[0], in[1], in[2]), along(in[3], in[4], in[5]);
        const glm::dvec3 place = water_at(found[i][0], found[i][1], in[6]);
        CHECK(glm::length(glm::cross(place - from, along)) < 0.01);  // metres from the ray
    }
    const Table fresnel =
        results_of("15_terrain_water.frag", "float fresnel(float cosine)", {{1}, {0}, {0.5}, {1.001}}, 1, sun);
    const auto exact = [](double c) {  // A.-J. Fresnel, 1823
        const double t = std::sqrt(1 - (1 - c * c) / (1.333 * 1.333));
        return 0.5 * (std::pow((c - 1.333 * t) / (c + 1.333 * t), 2) + std::pow((t - 1.333 * c) / (t + 1.333 * c), 2));
    };
    CHECK(fresnel[0][0] == Approx(exact(1)).margin(0.001));
    CHECK(fresnel[1][0] == Approx(1));
    CHECK(fresnel[2][0] == Approx(exact(0.5)).margin(0.02));
    CHECK(fresnel[3][0] == Approx(fresnel[0][0]));
    const Table left = results_of("15_terrain_water.frag", "vec3 left_of_light(float way)", {{0}, {2}, {4}}, 3, sun);
    CHECK(left[0] == Row{1, 1, 1});
    for (size_t c = 0; c < 3; ++c) CHECK(left[2][c] == Approx(left[1][c] * left[1][c]).epsilon(1e-4));
    CHECK(left[2][0] < 0.25 * left[2][2]);
}

TEST_CASE("17: the minimal planet is an ellipsoid, seen from near and from far") {
    Table inputs;
    Random random(17);
    for (int i = 0; i < 300; ++i) {
        const double away = i % 2 ? random.uniform(1.5, 6) : random.logarithmic(10, 3000);
        const glm::dvec3 from = away * glm::dvec3(random.direction());
        const glm::dvec3 aim(random.uniform(-0.8, 0.8), random.uniform(-0.8, 0.8), random.uniform(-0.8, 0.8));
        Row row;
        append(row, glm::vec3(from));
        append(row, glm::vec3(glm::normalize(aim - from)));
        inputs.push_back(row);
    }
    const Table found = results_of("17_planets.frag", "float planet_distance(vec3 from, vec3 direction)", inputs, 1,
                                   "const vec4 eye = vec4(0), to_sun = vec4(0);\n");
    int met = 0;
    for (size_t i = 0; i < inputs.size(); ++i) {
        const Row& in = inputs[i];
        const glm::dvec3 stretch(1, 1 / (1 - 0.098), 1), o = stretch * glm::dvec3(in[0], in[1], in[2]),
                                                         d = stretch * glm::dvec3(in[3], in[4], in[5]);
        const double b = glm::dot(o, d), a = glm::dot(d, d), root = b * b - a * (glm::dot(o, o) - 1);
        if (root < 1e-3 * a) continue;  // at the limb a float decides
        ++met;
        const double t = (-b - std::sqrt(root)) / a;
        CHECK(found[i][0] == Approx(t).epsilon(1e-5).margin(1e-4));
    }
    CHECK(met > 150);
}

TEST_CASE("17: the minimal rings send and pass the light of single scattering") {
    const std::string eye = "const vec4 eye = vec4(0), to_sun = vec4(0);\n";
    const std::string call =
        "\nfloat lit_light(float depth, float mu0, float mu) { return ring_light(depth, mu0, mu, true); }\n"
        "float unlit_light(float depth, float mu0, float mu) { return ring_light(depth, mu0, mu, false); }\n";
    Table inputs;
    for (const double depth : {0.1, 0.5, 1.8})
        for (const double mu0 : {0.1, 0.45, 0.9})
            for (const double mu : {0.1, 0.4500001, 0.46, 0.8}) inputs.push_back({depth, mu0, mu});
    const Table lit =
        results_of("17_planets.frag", "float lit_light(float depth, float mu0, float mu)", inputs, 1, eye, call);
    const Table unlit =
        results_of("17_planets.frag", "float unlit_light(float depth, float mu0, float mu)", inputs, 1, eye, call);
    for (size_t i = 0; i < inputs.size(); ++i) {
        // Layer by layer: light that arrives at a depth, is scattered there once, and leaves.
        const double depth = inputs[i][0], mu0 = inputs[i][1], mu = inputs[i][2];
        double back = 0, through = 0;
        constexpr int layers = 20000;
        for (int j = 0; j < layers; ++j) {
            const double t = depth * (j + 0.5) / layers, part = depth / layers / (4 * mu);
            back += part * std::exp(-t / mu0 - t / mu);
            through += part * std::exp(-t / mu0 - (depth - t) / mu);
        }
        CAPTURE(depth, mu0, mu);
        CHECK(lit[i][0] == Approx(back).epsilon(1e-3));
        CHECK(unlit[i][0] == Approx(through).epsilon(1e-3));
    }
    // The shadow of the rings: light that falls at 30 degrees through the B ring, and beside it.
    const Table shadow = results_of(
        "17_planets.frag", "float ring_shadow(vec3 at, vec3 sun)",
        {{0, -0.5, 0.83, 0, 0.5, 0.866025}, {0, 0.5, 0.83, 0, 0.5, 0.866025}, {0, -0.5, 0.2, 0, 0.5, 0.866025}}, 1,
        eye);
    CHECK(shadow[0][0] == Approx(std::exp(-1.8 / 0.5)).epsilon(1e-3));
    CHECK(shadow[1][0] == 1);
    CHECK(shadow[2][0] == 1);
}
