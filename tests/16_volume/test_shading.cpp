// How a volume reflects the light that reaches it, against closed forms: a white surface, a thin ramp, a lamp in thin air.
#include "16_volume/volume_data.h"
#include "volume_fixture.h"

using namespace lightwalk;

namespace {

constexpr double pi = 3.14159265358979;

/// White matter in sunlight; y points to the camera.
struct OnLit : OnVolume {
    OnLit() {
        in_sunlight();
        volume.shading.set("gradient");
        volume.shine.value = 0;
    }
    /// The sun's angle from the direction to the camera.
    void sun_at(double angle_deg) {
        const double angle = angle_deg * pi / 180;
        scene.set_sun({glm::vec3(float(std::sin(angle)), 0, float(std::cos(angle))), glm::vec3(2)});
    }
};

}  // namespace

TEST_CASE_METHOD(OnLit, "a surface reflects by Lambert's cosine and by Blinn's lobe, and does not shadow itself",
                 "[16.shading]") {
    load({32, 32, 32}, [](int, int y, int) { return y < 16 ? 1.0f : 0.0f; });
    volume.density.value = 200;
    for (const double angle_deg : {0.0, 30.0, 60.0}) {
        sun_at(angle_deg);
        INFO(angle_deg);
        const double lambert = 2 / pi * std::cos(angle_deg * pi / 180);
        volume.shine.value = 0;
        CHECK(double(middle().g) == Approx(lambert).epsilon(0.03));
        // The half vector is halfway.
        volume.shine.value = 0.5f;
        const double lobe = 2 / pi * 0.5 * std::pow(std::cos(0.5 * angle_deg * pi / 180), 40);
        CHECK(double(middle().g) == Approx(lambert + lobe).epsilon(0.03));
    }
}

// smoothstep(0.2, 1, 0.45) is 0.232.
TEST_CASE_METHOD(OnLit, "a surface is lit by what reaches it from outside, however finely its own steps are sampled",
                 "[16.shading]") {
    load({32, 32, 32}, [](int, int y, int) { return y < 16 ? 1.0f : 0.0f; });
    volume.density.value = 200;
    volume.light_steps.value = 128;
    sun_at(30);
    CHECK(double(middle().g) == Approx(2 / pi * std::cos(30 * pi / 180)).epsilon(0.03));
}

// Both ways pass the same matter: extinction times T² integrates to (1 - T²) / 2.
TEST_CASE_METHOD(OnLit, "light from behind the camera returns half of the square it loses, whatever the profile",
                 "[16.shading]") {
    load({2, 2, 2}, [](int, int y, int) { return y ? 0.0f : 1.0f; });
    volume.shading.set("none");
    volume.density.value = 0.05f;
    volume.light_steps.value = 6;
    camera.fov_y_rad = 0.06f;
    sun_at(0);
    const double lit = double(middle().g);
    volume.light.set("none");
    background = {1, 1, 1, 1};
    const double through = double(middle().g);
    REQUIRE(through < 0.5);
    CHECK(lit == Approx(2 / pi * 0.5 * (1 - through * through)).epsilon(0.03));
}

TEST_CASE_METHOD(OnLit, "where the density changes slowly, little of it is a surface", "[16.shading]") {
    load({32, 32, 32}, [](int, int y, int) { return 0.05f + 0.9f * (float(y) + 0.5f) / 32; });
    volume.density.value = 1e-4f;
    sun_at(0);  // behind the surface
    const double surface = double(middle().g);
    volume.shading.set("none");
    const double alike = double(middle().g);
    REQUIRE(alike > 1e-4);
    CHECK(surface / alike == Approx(1 - 0.232).margin(0.03));
}

TEST_CASE_METHOD(OnLit, "a lamp's light does not grow nearer to it than 0.1 m", "[16.shading]") {
    load({8, 8, 8}, [](int, int, int) { return 1.0f; });
    volume.shading.set("none");
    volume.light_from.set("heart");
    volume.heart.value = glm::vec3(1);
    volume.density.value = 1e-4f;
    volume.steps.value = 2048;
    camera.fov_y_rad = 0.06f;
    // Of 1 / max(r², 0.01) along 2 m through the lamp: 2 (0.1 · 100 + 1 / 0.1 - 1).
    const double extinction = -std::log(1 - even_opacity) / double(REFERENCE_M) * 1e-4;
    CHECK(double(middle().g) == Approx(extinction / pi * 38).epsilon(0.04));
}

TEST_CASE_METHOD(OnVolume, "the view of errors is sixteen times the difference from four steps a voxel",
                 "[16.error_view]") {
    volume.method.set("midpoint");
    volume.steps.value = 4 * volume.field.voxels.value;
    const ImageRgb fine = picture();
    volume.steps.value = 24;
    const ImageRgb coarse = picture();
    volume.show.set("error");
    const ImageRgb shown = picture();
    double most = 0;
    for (size_t i = 0; i < shown.pixels.size(); ++i) {
        const glm::vec3 wanted = 16.0f * glm::abs(coarse.pixels[i] - fine.pixels[i]);
        most = std::max(most, double(wanted.g));
        // Halves have eleven bits; differences of two of them are taken here.
        CHECK(double(glm::length(shown.pixels[i] - wanted)) < 0.02 + 0.02 * double(glm::length(wanted)));
    }
    CHECK(most > 0.1);
}

TEST_CASE("jittered pictures are averaged with equal weights, each with an offset of its own", "[16.jitter]") {
    const auto jittered = [](OnVolume& on) {
        on.volume.method.set("jittered");
        on.volume.steps.value = 12;
    };
    std::vector<ImageRgb> alone;
    for (const int index : {0, 1, 2}) {
        OnVolume on;
        jittered(on);
        on.frame.samples.index = index;
        alone.push_back(on.picture());
    }
    CHECK(mean_difference(alone[0], alone[1]) > 1e-3);
    OnVolume on;
    jittered(on);
    on.picture();
    on.picture();
    const ImageRgb third = on.picture();
    ImageRgb mean = alone[0];
    for (size_t i = 0; i < mean.pixels.size(); ++i)
        mean.pixels[i] = (alone[0].pixels[i] + alone[1].pixels[i] + alone[2].pixels[i]) / 3.0f;
    CHECK(mean_difference(third, mean) < 0.1 * mean_difference(alone[0], mean));
}
