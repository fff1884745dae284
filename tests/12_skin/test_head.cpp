// A whole head, or a ball in its place: energy, its size on the screen, light behind it.
#include <fmt/core.h>

#include "common/measure/metrics.h"
#include "head_fixture.h"

using namespace lightwalk;

namespace {

bool all_finite(const ImageRgb& picture) {
    for (const glm::vec3& p : picture.pixels)
        if (!std::isfinite(p.r) || !std::isfinite(p.g) || !std::isfinite(p.b)) return false;
    return true;
}

double largest_difference(const ImageRgb& a, const ImageRgb& b) {
    double worst = 0;
    for (size_t i = 0; i < a.pixels.size(); ++i)
        for (int c = 0; c < 3; ++c) worst = std::max(worst, std::fabs(double(a.pixels[i][c] - b.pixels[i][c])));
    return worst;
}

}  // namespace

TEST_CASE_METHOD(OnHead, "in a furnace skin neither gains nor loses light, by any method, rough or smooth",
                 "[12.furnace]") {
    load(furnace(0.5f));
    skin.f0.value = 0.028f;
    for (const std::string& method : skin.method.options)
        for (const float roughness : {0.5f, 2.0f}) {
            skin.method.set(method);
            skin.roughness.value = roughness;
            skin.map_size.value = 128;
            const ImageRgb picture = draw({48, 48});
            double worst = 0;
            for (int y = 12; y < 36; ++y)
                for (int x = 12; x < 36; ++x)
                    for (int c = 0; c < 3; ++c)
                        worst = std::max(worst, std::fabs(double(picture.at(x, y)[c]) / 0.5 - 1));
            INFO(method << " " << roughness);
            CHECK(worst < 0.01);
        }
}

TEST_CASE_METHOD(OnHead, "the map follows the head's size on the screen, and a head of 30 pixels needs no blur",
                 "[12.map_size]") {
    load(portrait());
    const DrawItem& head = *skin.skin_of(scene);
    Camera camera = scene.file.camera;
    const glm::vec3 away = camera.position - camera.target;
    uint32_t before = 4096;
    for (const float pixels : {1000.0f, 500.0f, 250.0f, 100.0f, 30.0f}) {
        // The head is 0.234 m high.
        const float distance = 0.234f * 540 / pixels / (2 * std::tan(0.5f * camera.fov_y_rad));
        camera.position = camera.target + distance * glm::normalize(away);
        const uint32_t size = skin.size_for(head, camera, 540);
        fmt::print("a head of {} pixels: a map of {} texels\n", pixels, size);
        CHECK(size <= before);
        CHECK(double(size) < 4.0 * double(pixels));
        before = size;
    }
    CHECK(before <= 128);
    scene.file.camera = camera;  // 30 pixels in a picture 540 high: of 60 here, three times as near
    scene.file.camera.position = camera.target + 9.0f * 0.234f / 3 / (2 * std::tan(0.5f * camera.fov_y_rad)) * 2.0f *
                                                     glm::normalize(away) / 3.0f;
    skin.method.set("lambert");
    const ImageRgb plain = draw({60, 60});
    skin.method.set("gaussians_6");
    const ImageRgb spread = draw({60, 60});
    CHECK(all_finite(plain));
    CHECK(all_finite(spread));
    CHECK(difference(spread, plain).rmse < 0.02);

    // Its highlights, near, with specular terms from tables: close to the closed ones, and not the same.
    scene.file.camera = portrait().camera;
    skin.method.set("lambert");
    const ImageRgb closed = draw({64, 48});
    skin.specular.set("tables");
    const ImageRgb tables = draw({64, 48});
    const double far = largest_difference(closed, tables);
    fmt::print("tables: the largest difference is {:.4f}, the root of the mean square {:.5f}\n", far,
               difference(closed, tables).rmse);
    CHECK(far > 0);
    CHECK(difference(closed, tables).rmse < 0.01);
}

TEST_CASE_METHOD(OnHead, "a light that moves behind the ear: light through it comes and goes without a jump") {
    load(portrait());
    skin.method.set("lambert");
    skin.specular_scale.value = 0;
    shadow.resolution.value = 512;
    const float wide = 3.0f;
    scene.file.environment = {};
    scene.environment = nullptr;
    scene.file.ambient = glm::vec3(0);
    scene.file.lights.resize(1);
    Light& light = scene.file.lights.front();
    // The ear, from its side, large in the picture.
    scene.file.camera = {
        .position = {0.35f, 0.0f, 0.12f}, .target = {0.078f, 0.0f, -0.015f}, .fov_y_rad = 0.3f, .near_m = 0.05f};
    ImageRgb before;
    double most = 0, jump = 0, redness = 0;
    for (int i = 0; i <= 10; ++i) {
        const float angle = 0.35f + 0.1f * float(i);  // from behind the head to beside it
        light.position = {0.9f * std::sin(angle), 0.05f, -0.9f * std::cos(angle)};
        light.direction = glm::normalize(glm::vec3(0.078f, 0, -0.015f) - light.position);
        skin.translucency.value = 0.01f;  // nothing comes through
        const ImageRgb without = draw({40, 40});
        skin.translucency.value = wide;
        const ImageRgb with = draw({40, 40});
        REQUIRE(all_finite(with));
        ImageRgb through = with;
        glm::dvec3 sum(0);
        for (size_t p = 0; p < through.pixels.size(); ++p) {
            through.pixels[p] -= without.pixels[p];
            sum += glm::dvec3(through.pixels[p]);
        }
        most = std::max(most, sum.r);
        if (sum.r > 1) redness = std::max(redness, sum.r / std::max(sum.g, 1e-6));
        if (!before.pixels.empty()) {
            double change = 0;
            for (size_t p = 0; p < through.pixels.size(); ++p)
                change += std::fabs(double(through.pixels[p].r - before.pixels[p].r));
            jump = std::max(jump, change);
        }
        before = through;
    }
    fmt::print("through the ear: {:.1f} at most, {:.1f} times as much red as green, {:.2f} of it in one step\n", most,
               redness, jump / most);
    CHECK(most > 1);
    CHECK(redness > 3);
    CHECK(jump < 0.8 * most);  // 0.1 rad: the ear is no wider from there
}
