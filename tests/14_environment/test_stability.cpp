// Where environment light goes wrong: a bound where the methods hold, the size of the failure where they do not.
#include <fmt/core.h>

#include "light_fixture.h"

using namespace lightwalk;

namespace {

/// The mean over directions of |found - right| / mean of right, of green.
double mean_error(const std::vector<glm::dvec3>& found, const std::vector<glm::dvec3>& right) {
    double away = 0, sum = 0;
    for (size_t i = 0; i < right.size(); ++i) {
        away += std::fabs(found[i].g - right[i].g);
        sum += right[i].g;
    }
    return away / sum;
}

/// Expected contents of the prefiltered cube: samples weighed by n·l, in the limit of every texel of a picture.
std::vector<glm::dvec3> true_prefiltered(const ImageRgb& picture, const std::vector<glm::vec3>& normals, double alpha) {
    std::vector<glm::dvec3> sums(normals.size(), glm::dvec3(0));
    std::vector<double> weights(normals.size(), 0);
    for (int y = 0; y < picture.height; ++y) {
        const double solid_angle = truth::equirect_solid_angle(y, picture.width, picture.height);
        for (int x = 0; x < picture.width; ++x) {
            const glm::dvec3 l = truth::direction_at({(x + 0.5) / picture.width, (y + 0.5) / double(picture.height)});
            for (size_t i = 0; i < normals.size(); ++i) {
                const double n_dot_l = glm::dot(glm::dvec3(normals[i]), l);
                if (n_dot_l <= 0) continue;
                const double weight =
                    solid_angle * n_dot_l * truth::ggx_density(std::sqrt(0.5 + 0.5 * n_dot_l), alpha) / 4;
                sums[i] += weight * glm::dvec3(picture.at(x, y));
                weights[i] += weight;
            }
        }
    }
    for (size_t i = 0; i < sums.size(); ++i) sums[i] /= weights[i];
    return sums;
}

}  // namespace

TEST_CASE_METHOD(OnLight, "the same on the device: a small sun leaves negative light in sh9, none in the cube") {
    load(256, 128, [](glm::dvec3 d) { return glm::dvec3(d.y > std::cos(0.05) ? 400.0 : 0.0); });
    std::vector<glm::vec3> normals;
    for (int i = 0; i <= 36; ++i) normals.emplace_back(std::sin(i * 0.0872665), std::cos(i * 0.0872665), 0.0f);
    light.diffuse.set("sh9");
    const auto sh = diffuse(normals);
    light.diffuse.set("irradiance");
    const auto cube = diffuse(normals);
    float least_sh = 1, least_cube = 1;
    for (size_t i = 0; i < normals.size(); ++i) {
        least_sh = std::min(least_sh, sh[i].g / sh[0].g);
        least_cube = std::min(least_cube, cube[i].g);
    }
    CHECK(least_sh < -0.03f);
    CHECK(least_sh > -0.05f);
    CHECK(least_cube >= 0.0f);
    light.sh_window.set("sinc4");
    light.diffuse.set("sh9");
    for (const glm::vec3 one : diffuse(normals)) CHECK(one.g > 0.0f);
}

TEST_CASE_METHOD(OnLight, "prefiltering at roughness 0.5: samples read from levels, and one level smoother",
                 "[14.few_samples]") {
    const auto normals = all_around(120);
    light.method.set("prefiltered");
    for (const std::string name : {"city_1k", "sunset_1k"}) {
        load("environments/" + name + ".hdr");
        const auto right = true_prefiltered(small_picture(gpu, *scene.environment, 256), normals, 0.25);
        double error[2][3];
        for (int biased = 0; biased < 2; ++biased)
            for (int i = 0; i < 3; ++i) {
                light.prefilter.bias.value = float(biased);
                light.prefilter.samples.value = 16 << (2 * i);
                // Level 3 of 7 has roughness 0.5; f0 1 and n·v 1, over the table's value.
                std::vector<LookedAt> surfaces;
                for (const glm::vec3 n : normals) surfaces.push_back({n, n, glm::vec3(1), 0.25f});
                std::vector<glm::dvec3> found;
                for (const Shown& one : shown(surfaces))
                    found.push_back(glm::dvec3(one.specular) / (1.0 - glm::dvec3(one.diffuse_share)));
                error[biased][i] = mean_error(found, right);
            }
        for (int biased = 0; biased < 2; ++biased)
            for (int i = 0; i < 3; ++i)
                fmt::print("{}, {}, {} samples: {:.4f}\n", name, biased ? "one level smoother" : "as they are",
                           16 << (2 * i), error[biased][i]);
        INFO(name);
        CHECK(error[1][1] < 0.12);
        CHECK(error[1][2] < 0.08);
        CHECK(error[1][2] < error[1][0]);
    }
}

TEST_CASE_METHOD(OnLight, "furnace: GGX loses up to 59% of white light; with multiple scattering nothing is lost") {
    load("", glm::vec3(0.5f));
    const double lost[] = {0.013, 0.12, 0.30, 0.46, 0.59};
    int row = 0;
    for (const float alpha : {0.0625f, 0.25f, 0.5f, 0.75f, 1.0f}) {
        std::vector<LookedAt> surfaces;  // the mean over angles: cosines are even in the projected area
        for (int i = 0; i < 32; ++i) {
            const float c = std::sqrt((float(i) + 0.5f) / 32.0f);
            surfaces.push_back({{0, 1, 0}, {std::sqrt(1 - c * c), c, 0}, glm::vec3(1), alpha});
        }
        const auto mean = [&](const char* method) {
            light.method.set(method);
            double sum = 0;
            for (const Shown& one : shown(surfaces)) sum += double(one.specular.g) / 0.5 / 32;
            return sum;
        };
        INFO("alpha " << alpha);
        CHECK(1 - mean("dominant") == Approx(lost[row++]).margin(0.012));
        CHECK(mean("multiscatter") == Approx(1).margin(0.006));
    }
}

TEST_CASE_METHOD(OnLight, "white of any metalness returns all of a furnace's light, at any roughness",
                 "[14.metalness]") {
    load("", glm::vec3(1.0f));
    light.method.set("multiscatter");
    std::vector<LookedAt> surfaces;
    for (const float alpha : {0.01f, 0.1f, 0.4f, 1.0f})
        for (const float c : {0.05f, 0.3f, 0.7f, 1.0f})
            for (const float m : {0.0f, 0.1f, 0.5f, 0.9f, 1.0f})
                surfaces.push_back({{0, 0, 1},
                                    {0, std::sqrt(1 - c * c), c},
                                    glm::vec3(0.04f * (1 - m) + m),
                                    alpha,
                                    glm::vec3(1 - m),
                                    1});
    const auto found = shown(surfaces);
    for (size_t i = 0; i < surfaces.size(); ++i) {
        INFO("alpha " << surfaces[i].alpha << ", n.v " << surfaces[i].to_eye.z << ", body " << surfaces[i].body.x);
        CHECK(double(found[i].specular.g + surfaces[i].body.g * found[i].diffuse_share.g) == Approx(1).margin(0.012));
    }
}

TEST_CASE_METHOD(OnLight, "nothing reflects more than arrives: every method, colour and roughness in a furnace") {
    load("", glm::vec3(1.0f));
    std::vector<LookedAt> surfaces;
    for (const float alpha : {1e-4f, 0.01f, 0.1f, 0.4f, 1.0f})
        for (const float c : {1e-4f, 0.05f, 0.3f, 0.7f, 1.0f})
            for (const float f0 : {0.0f, 0.04f, 0.5f, 1.0f})
                surfaces.push_back({{0, 0, 1}, {0, std::sqrt(1 - c * c), c}, glm::vec3(f0), alpha});
    for (const std::string& method : light.method.options) {
        light.method.set(method);
        for (const Shown& one : shown(surfaces)) {
            const float all = one.specular.g + one.diffuse_share.g;
            INFO(method);
            CHECK(is_finite(one.specular));
            CHECK(all <= 1.05f);  // 64 samples
            CHECK(one.diffuse_share.g >= 0.0f);
        }
    }
}

TEST_CASE_METHOD(OnLight, "every normal has a frame: the poles, the axes, and between them") {
    load(64, 32, [](glm::dvec3 d) { return 0.5 * d + 0.5; });
    light.method.set("sampled");
    std::vector<LookedAt> surfaces;
    for (const glm::vec3 n : all_around(200)) surfaces.push_back({n, n, glm::vec3(1), 0.05f});
    for (const float tiny : {1e-8f, -1e-8f, 1e-4f, -1e-4f})
        for (const float side : {1.0f, -1.0f})
            surfaces.push_back({{tiny, 0, side}, {tiny, 0, side}, glm::vec3(1), 0.05f});
    const auto found = shown(surfaces);
    for (size_t i = 0; i < surfaces.size(); ++i)
        CHECK(glm::length(glm::dvec3(found[i].specular) - (0.5 * glm::dvec3(surfaces[i].normal) + 0.5)) < 0.03);
}

TEST_CASE_METHOD(OnLight, "roughness 0 is a mirror, by every method that has one") {
    load(128, 64, [](glm::dvec3 d) { return glm::dvec3(d.x > 0 ? 1.0 : 0.25); });
    const glm::vec3 to_eye = glm::normalize(glm::vec3(-0.3f, 0.8f, 0.2f));
    for (const char* method : {"mirror", "box_mips", "prefiltered", "dominant", "multiscatter", "sampled", "truth"}) {
        light.method.set(method);
        const auto found =
            shown({{{0, 1, 0}, to_eye, glm::vec3(1), 0.0f}, {{0, 1, 0}, {0.3f, 0.8f, 0.2f}, glm::vec3(1), 0.0f}});
        INFO(method);
        CHECK(double(found[0].specular.g) == Approx(1.0).margin(0.02));
        CHECK(double(found[1].specular.g) == Approx(0.25).margin(0.02));
    }
}

TEST_CASE_METHOD(OnLight, "a sun of 3e5 in a sky of 1: half floats keep a fifth of it, and nothing overflows") {
    const auto sky = [](glm::dvec3 d) { return glm::dvec3(d.y > std::cos(0.03) ? 3e5 : 1.0); };
    load(256, 128, sky);
    ImageRgb right(256, 128);
    for (int y = 0; y < 128; ++y)
        for (int x = 0; x < 256; ++x)
            right.at(x, y) = glm::vec3(sky(truth::direction_at({(x + 0.5) / 256, (y + 0.5) / 128})));
    const std::vector<glm::vec3> up{{0, 1, 0}};
    const double found = diffuse(up)[0].g, whole = true_diffuse(right, up)[0].g;
    INFO(found << " of " << whole);
    CHECK(found / whole > 0.15);
    CHECK(found / whole < 0.28);
    for (const std::string& method : light.method.options) {
        light.method.set(method);
        std::vector<LookedAt> surfaces;
        for (const glm::vec3 n : all_around()) surfaces.push_back({n, n, glm::vec3(1), 0.1f});
        for (const Shown& one : shown(surfaces)) CHECK(is_finite(one.specular));
    }
}

TEST_CASE_METHOD(OnLight, "a black picture shows nothing, and a picture of two texels its colours") {
    load(2, 1, [](glm::dvec3) { return glm::dvec3(0); });
    for (const std::string& method : light.method.options) {
        light.method.set(method);
        for (const Shown& one : shown({{{0, 1, 0}, {0, 1, 0}, glm::vec3(1), 0.2f}})) {
            CHECK(one.specular == glm::vec3(0));
            CHECK(one.diffuse == glm::vec3(0));
        }
    }
    load(2, 1, [](glm::dvec3) { return glm::dvec3(0.5, 1, 2); });
    for (const glm::vec3 one : diffuse(all_around())) CHECK(glm::length(one - glm::vec3(0.5, 1, 2)) < 0.02f);
}
