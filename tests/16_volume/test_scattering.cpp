// Scattered light against closed forms and integrals: a box of even matter, a furnace, a half space, a thin haze.
#include <array>
#include <numbers>
#include <vector>

#include "16_volume/volume_data.h"
#include "volume_fixture.h"

using namespace lightwalk;

namespace {

double henyey_greenstein(double cosine, double g) {
    return (1 - g * g) / (4 * std::numbers::pi * std::pow(1 + g * g - 2 * g * cosine, 1.5));
}

/// A box of 2 m of even matter, seen along -z, in sunlight of irradiance 2; `even` at density 1 has 22.3 per metre.
struct OnBox : OnVolume {
    double extinction = 0;
    OnBox() {
        load({4, 4, 4}, [](int, int, int) { return 1.0f; });
        in_sunlight();
        volume.scattering.set("single");
        volume.g.value = 0;
        camera.fov_y_rad = 0.06f;
        thick(3);
        sun_at({0, 0, 1});
    }
    /// Optical depth of the 2 m.
    void thick(double depth) {
        extinction = depth / 2;
        volume.density.value = float(-extinction * double(REFERENCE_M) / std::log(1 - even_opacity));
    }
    void sun_at(glm::dvec3 to_sun, double irradiance = 2) {
        scene.set_sun({glm::vec3(glm::normalize(to_sun)), glm::vec3(float(irradiance))});
    }
    double mean() {
        double sum = 0;
        const ImageRgb drawn = picture();
        for (const glm::vec3& pixel : drawn.pixels) sum += double(pixel.g);
        return sum / double(drawn.pixels.size());
    }
};

const char* const every_scattering[] = {"single", "octaves", "conserving", "walk"};

double rms_difference(const ImageRgb& a, const ImageRgb& b) {
    double sum = 0;
    for (size_t i = 0; i < a.pixels.size(); ++i) sum += std::pow(double(a.pixels[i].g) - double(b.pixels[i].g), 2);
    return std::sqrt(sum / double(a.pixels.size()));
}

}  // namespace

TEST_CASE_METHOD(DeviceTest, "the phase function integrates to 1 over all directions, and its mean cosine is g",
                 "[16.phase]") {
    Probe probe{.include = "16_volume/phase.glsl",
                .signature = "float phase(float cosine, float g)",
                .truth = [](auto in) { return Row{henyey_greenstein(in[0], in[1])}; },
                .bound = {.relative = 1e-4}};
    constexpr int parts = 2000;
    for (const double g : {-0.5, 0.0, 0.4, 0.85}) {
        probe.inputs.clear();
        for (int i = 0; i < parts; ++i) probe.inputs.push_back({-1 + (i + 0.5) * 2 / parts, g});
        const auto out = run_probe(gpu, probe, 1);
        CHECK(worst_of(probe, out) == "");
        double sum = 0, cosine = 0;
        for (size_t i = 0; i < out.size(); ++i) {
            sum += 2 * std::numbers::pi * out[i][0] * 2 / parts;
            cosine += probe.inputs[i][0] * 2 * std::numbers::pi * out[i][0] * 2 / parts;
        }
        INFO(g);
        CHECK(sum == Approx(1).epsilon(1e-3));
        CHECK(cosine == Approx(g).margin(1e-3));
    }
}

TEST_CASE_METHOD(DeviceTest, "drawn scattering angles have the phase function's moments", "[16.phase]") {
    Probe probe{.include = "common/henyey_greenstein.glsl",
                .signature = "float henyey_greenstein_cosine(float g, float x)",
                .truth = [](auto) { return Row{0}; },
                .bound = {.absolute = 1}};
    constexpr int parts = 2000;
    for (const double g : {-0.5, 0.0, 0.4, 0.85}) {
        probe.inputs.clear();
        for (int i = 0; i < parts; ++i) probe.inputs.push_back({g, -1 + (i + 0.5) * 2 / parts});
        double cosine = 0, square = 0;
        for (const auto& out : run_probe(gpu, probe, 1)) {
            cosine += out[0] / parts;
            square += out[0] * out[0] / parts;
        }
        INFO(g);
        CHECK(cosine == Approx(g).margin(1e-3));
        CHECK(square == Approx((1 + 2 * g * g) / 3).margin(1e-3));  // its moments are g^n in Legendre polynomials
    }
}

// In a furnace all that is lost on a path comes in from the sides, whatever the phase function and the density.
TEST_CASE_METHOD(OnBox, "a white cloud in a furnace is invisible", "[16.white_cloud]") {
    volume.light.set("none");
    volume.sky.value = glm::vec3(0.5f);
    background = {0.5f, 0.5f, 0.5f, 1};
    camera.fov_y_rad = 0.9f;
    load({8, 8, 8}, [](int x, int y, int z) { return 0.125f * float((x + 2 * y + 3 * z) % 8); });
    for (const char* scattering : every_scattering)
        for (const double g : {0.0, 0.85}) {
            INFO(scattering << ", g " << g);
            volume.scattering.set(scattering);
            volume.g.value = float(g);
            thick(12);
            for (const glm::vec3& pixel : picture().pixels) CHECK(double(pixel.g) == Approx(0.5).epsilon(0.004));
        }
    // A grey one is seen.
    volume.albedo.value = 0.8f;
    CHECK(double(middle().g) < 0.4);
}

// Of the source term, sigma times albedo times E times p times both transmittances, along z.
TEST_CASE_METHOD(OnBox, "single scattering of even matter is its integral, from every side", "[16.single]") {
    load({64, 64, 64}, [](int, int, int) { return 1.0f; });
    for (const double depth : {0.5, 4.0})
        for (const double angle_deg : {0.0, 40.0, 90.0, 150.0}) {
            const double angle = angle_deg * std::numbers::pi / 180, sine = std::sin(angle), cosine = std::cos(angle);
            thick(depth);
            sun_at({sine, 0, cosine});
            volume.g.value = 0.6f;
            volume.albedo.value = 0.7f;
            double right = 0;
            constexpr int parts = 20000;
            for (int i = 0; i < parts; ++i) {
                const double s = 2 * (i + 0.5) / parts, z = 1 - s;
                const double along_z = std::abs(cosine) < 1e-9 ? 1e9 : (cosine > 0 ? 1 - z : 1 + z) / std::abs(cosine);
                const double to_sun = std::min(along_z, sine < 1e-9 ? 1e9 : 1 / sine);
                right += 2.0 / parts * extinction * 0.7 * 2 * std::exp(-extinction * (s + to_sun));
            }
            right *= henyey_greenstein(-cosine, 0.6);  // light goes along -to_sun, and then along +z to the eye
            INFO(depth << ", " << angle_deg);
            CHECK(double(middle().g) == Approx(right).epsilon(0.015));
            volume.light.set("volume");
            CHECK(double(middle().g) == Approx(right).epsilon(0.04));
            volume.light.set("march");
        }
}

// Light is reflected by half a space of isotropic scatterers as H(mu) H(mu0) say, S. Chandrasekhar, "Radiative Transfer",
// 1950; here mu = mu0 = 1, and H by its integral equation.
TEST_CASE_METHOD(OnBox, "random walks reflect as much of half a space as Chandrasekhar's function says", "[16.walk]") {
    volume.scattering.set("walk");
    volume.paths.value = 32;
    thick(80);
    for (const double albedo : {0.5, 0.9}) {
        constexpr int n = 200;
        std::vector<double> h(n, 1);
        const auto h_at = [&](double mu) {
            double sum = 0;
            for (size_t i = 0; i < n; ++i) sum += h[i] / (mu + (double(i) + 0.5) / n) / n;
            return 1 / (1 - 0.5 * albedo * mu * sum);
        };
        for (int round = 0; round < 60; ++round) {
            std::vector<double> next(n);
            for (size_t i = 0; i < n; ++i) next[i] = 0.5 * (h[i] + h_at((double(i) + 0.5) / n));
            h = next;
        }
        volume.albedo.value = float(albedo);
        const double right = 2 * albedo / (4 * std::numbers::pi) * 0.5 * h_at(1) * h_at(1);
        INFO(albedo);
        CHECK(mean() == Approx(right).epsilon(0.02));
    }
}

TEST_CASE_METHOD(OnBox, "random walks let through what the reference march lets through", "[16.walk]") {
    load({8, 8, 8}, [](int x, int y, int z) { return (x + 2 * y + 3 * z) % 8 < 2 ? 1.0f : 0.1f; });
    background = {1, 1, 1, 1};
    volume.albedo.value = 0;
    camera.fov_y_rad = 0.5f;
    volume.method.set("exact");
    const double right = mean();
    REQUIRE(right < 0.7);
    volume.scattering.set("walk");
    volume.paths.value = 64;
    CHECK(mean() == Approx(right).epsilon(0.01));
}

TEST_CASE_METHOD(OnBox, "the error of random walks falls with the root of their number", "[16.walk]") {
    volume.scattering.set("walk");
    volume.g.value = 0.5f;
    background = {1, 1, 1, 1};
    volume.paths.value = 64;
    ImageRgb right = picture();
    for (int i = 1; i < 8; ++i) right = picture();
    CHECK(volume.pictures(0) == 8);
    frame.seed = 1;
    const auto error = [&](int paths) {
        volume.paths.value = paths;
        return rms_difference(picture(), right);
    };
    const double few = error(2), many = error(32);
    CHECK(few / many > 3.2);
    CHECK(few / many < 4.8);
    // So does that of pictures of one view.
    volume.paths.value = 2;
    ImageRgb mean = picture();
    for (int i = 1; i < 16; ++i) mean = picture();
    CHECK(rms_difference(mean, right) == Approx(many).epsilon(0.2));
}

// A lens of directions: each of them brings its share of a radiance of 1 from everywhere.
TEST_CASE_METHOD(OnBox, "light from everywhere returns no more by conserving octaves than arrived", "[16.octaves]") {
    constexpr int directions = 40;
    background = {0, 0, 0, 1};
    const auto returned = [&](const char* scattering, double depth) {
        volume.scattering.set(scattering);
        thick(depth);
        double sum = std::exp(-depth);  // of the radiance of 1 behind it
        for (int i = 0; i < directions; ++i) {
            const double z = 1 - 2 * (i + 0.5) / directions, around = i * std::numbers::pi * (3 - std::sqrt(5.0));
            const double side = std::sqrt(1 - z * z);
            sun_at({side * std::cos(around), side * std::sin(around), z}, 4 * std::numbers::pi / directions);
            sum += double(middle().g);
        }
        return sum;
    };
    volume.steps.value = 128;
    for (const double depth : {0.2, 2.0, 20.0}) {
        INFO(depth);
        const double single = returned("single", depth), conserving = returned("conserving", depth);
        CHECK(conserving > single);
        CHECK(conserving < 1.005);
    }
    // The plain sum adds light where the matter is thin.
    CHECK(returned("octaves", 0.2) > 1.1);
}

TEST_CASE_METHOD(OnBox, "a thin haze scatters once: plain octaves return nearly twice as much", "[16.thin_octaves]") {
    thick(0.02);
    sun_at({0, 1, 0}, 200);
    const double single = double(middle().g);
    REQUIRE(single == Approx(0.02 * 200 / (4 * std::numbers::pi)).epsilon(0.03));
    volume.scattering.set("conserving");
    CHECK(double(middle().g) == Approx(single).epsilon(0.015));
    volume.scattering.set("octaves");
    CHECK(double(middle().g) == Approx(single * (2 - 1.0 / 32)).epsilon(0.015));
}
