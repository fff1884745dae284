// Environment light against sums in double precision.
#include <fmt/core.h>

#include <glm/gtc/packing.hpp>

#include "light_fixture.h"

using namespace lightwalk;

TEST_CASE_METHOD(OnLight, "an even environment: every method of diffuse light shows its radiance") {
    load("", {0.25f, 0.5f, 2.0f});
    for (const char* method : {"constant", "sh9", "irradiance"}) {
        light.diffuse.set(method);
        INFO(method);
        for (const glm::vec3 found : diffuse(all_around()))
            for (int c = 0; c < 3; ++c) CHECK(double(found[c]) == Approx(double(scene.file.ambient[c])).epsilon(4e-3));
    }
}

TEST_CASE_METHOD(OnLight, "what is where: the cube, irradiance and spherical harmonics agree with the picture") {
    load(64, 32, [](glm::dvec3 d) { return 0.5 * d + 0.5; });
    const auto normals = all_around();
    for (const char* method : {"sh9", "irradiance"}) {
        light.diffuse.set(method);
        INFO(method);
        for (const float turn : {0.0f, 90.0f, -37.0f}) {
            light.turn_deg.value = turn;
            const auto found = diffuse(normals);
            const double a = glm::radians(double(turn));
            for (size_t i = 0; i < normals.size(); ++i) {
                const glm::dvec3 n(normals[i]);  // in the picture's space, then 2/3 of a linear light
                const glm::dvec3 in(std::cos(a) * n.x - std::sin(a) * n.z, n.y, std::cos(a) * n.z + std::sin(a) * n.x);
                CHECK(glm::length(glm::dvec3(found[i]) - (in / 3.0 + 0.5)) < 0.01);
            }
        }
    }
    light.turn_deg.value = 0;
    light.method.set("mirror");
    std::vector<LookedAt> mirrors;
    for (const glm::vec3 n : normals) mirrors.push_back({n, n, glm::vec3(1), 1e-4f});
    const auto seen = shown(mirrors);
    for (size_t i = 0; i < normals.size(); ++i)
        CHECK(glm::length(glm::dvec3(seen[i].specular) - (0.5 * glm::dvec3(normals[i]) + 0.5)) < 0.02);
}

TEST_CASE_METHOD(OnLight, "irradiance of photographed places: the cube within 4% of the brightest, sh9 within 20%") {
    for (const std::string name : {"city_1k", "sunset_1k", "courtyard_1k", "sunrise_1k"}) {
        load("environments/" + name + ".hdr");
        const ImageRgb picture = small_picture(gpu, *scene.environment, 256);
        const auto normals = all_around();
        const auto right = true_diffuse(picture, normals);
        double most = 0;
        for (const glm::dvec3& one : right) most = std::max(most, one.g);
        for (const auto& [method, bound] : {std::pair{"irradiance", 0.04}, {"sh9", 0.2}}) {
            light.diffuse.set(method);
            const auto found = diffuse(normals);
            double worst = 0, least = 1;
            for (size_t i = 0; i < normals.size(); ++i) {
                worst = std::max(worst, std::fabs(double(found[i].g) - right[i].g) / most);
                least = std::min(least, double(found[i].g));
            }
            INFO(name << " " << method << ": worst " << worst << " least " << least);
            CHECK(worst < bound);
        }
    }
}

TEST_CASE_METHOD(OnLight, "coefficients that the device sums are those of 14.sh_project") {
    load("environments/courtyard_1k.hdr");
    draw_picture();
    frame.end();
    const auto of_picture = read<glm::vec4>(light.sky.sh);
    const auto of_cube = read<glm::vec4>(light.drawn.sh);
    frame.begin({4, 4}, 0);
    for (size_t i = 0; i < 9; ++i) {
        INFO(i);
        CHECK(glm::length(of_cube[i] - of_picture[i]) < 0.01f * glm::length(of_picture[0]));
    }
}

TEST_CASE_METHOD(OnLight, "the split sum's table against sums in double precision", "[14.split_sum]") {
    load("");
    frame.end();
    const auto bytes = gpu.read_back(light.table);
    frame.begin({4, 4}, 0);
    const auto at = [&](uint32_t x, uint32_t y) {
        uint64_t texel = 0;
        std::memcpy(&texel, bytes.data() + 8 * (y * 64 + x), 8);
        return glm::unpackHalf4x16(texel);
    };
    for (const uint32_t y : {6u, 16u, 32u, 63u})
        for (const uint32_t x : {1u, 2u, 3u, 6u, 20u, 40u, 63u}) {
            const double n_dot_v = x / 63.0, alpha = y / 63.0;
            const double both = truth::white_reflection(n_dot_v, alpha, 1),
                         b = truth::white_reflection(n_dot_v, alpha, 0);
            INFO("n.v " << n_dot_v << ", alpha " << alpha);
            CHECK(double(at(x, y).x) == Approx(both - b).margin(4e-3));
            CHECK(double(at(x, y).y) == Approx(b).margin(4e-3));
        }
}

TEST_CASE_METHOD(OnLight, "light that leaves after several facets is reflected by Schlick's formula in the mean",
                 "[14.mean_fresnel]") {
    load("", glm::vec3(1));
    for (const double f0 : {0.04, 0.3, 0.7}) {
        // The mean over a half sphere, weighed by the cosine, by a sum.
        double mean = 0;
        for (int i = 0; i < 4000; ++i) {
            const double c = (i + 0.5) / 4000;
            mean += 2 * c * (f0 + (1 - f0) * std::pow(1 - c, 5)) / 4000;
        }
        const glm::vec3 n(0, 0, 1), to_eye(0.8f, 0, 0.6f);
        const auto reflected = [&](const char* method) {
            light.method.set(method);
            return double(shown({{n, to_eye, glm::vec3(float(f0)), 1.0f}}).front().specular.g);
        };
        const double single = truth::white_reflection(0.6, 1, f0);
        const double missing = 1 - truth::white_reflection(0.6, 1, 1);
        const double right = single * mean * missing / (1 - mean * missing);
        INFO("F0 " << f0);
        CHECK(reflected("multiscatter") - reflected("dominant") == Approx(right).epsilon(0.03).margin(1e-4));
    }
}

TEST_CASE_METHOD(
    OnLight, "the sum over all texels and many samples agree, turned or not, with every roughness in one dispatch") {
    load("environments/courtyard_1k.hdr");
    std::vector<LookedAt> surfaces;
    for (const glm::vec3 n : all_around(10))
        for (const float alpha : {0.01f, 0.06f, 0.12f, 0.3f, 0.6f, 1.0f}) {
            const glm::vec3 side = std::fabs(n.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
            const glm::vec3 to_eye = glm::normalize(n + 0.7f * glm::normalize(glm::cross(n, side)));
            surfaces.push_back({n, to_eye, glm::vec3(1), alpha});
        }
    light.samples.value = 2048;
    light.sample_bias.value = 0;
    for (const float turn : {0.0f, 70.0f}) {
        light.turn_deg.value = turn;
        light.method.set("truth");
        const auto sums = shown(surfaces);
        light.method.set("sampled");
        const auto samples = shown(surfaces);
        double away = 0, all = 0;
        for (size_t i = 0; i < surfaces.size(); ++i) {
            away += double(std::fabs(sums[i].specular.g - samples[i].specular.g));
            all += double(samples[i].specular.g);
        }
        INFO("turned by " << turn << ": " << away / all);
        CHECK(away / all < 0.02);
    }
}
