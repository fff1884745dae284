// Where volumes go wrong: a bound where the methods hold, the size of the failure where they do not.
#include <fmt/core.h>

#include "16_volume/volume.h"
#include "volume_fixture.h"

using namespace lightwalk;

TEST_CASE_METHOD(OnVolume,
                 "an even volume: every method gives the closed form, from outside, inside and before a wall") {
    load({8, 8, 8}, [](int, int, int) { return 1.0f; });
    volume.transfer.set("even");
    volume.density.value = 0.03f;
    volume.steps.value = 128;
    for (const char* method : every_method) {
        volume.method.set(method);
        INFO(method);
        // Rays through the middle go 2 m through the box, a pixel or so off the axis.
        camera.position = {0, 0, 3};
        wall_m = 0;
        CHECK(double(middle().g) == Approx(even_light(2, 0.03)).margin(std::string(method) == "sum" ? 0.01 : 0.002));
        // The eye in the middle: the half that lies before it, and no more.
        camera.position = {0, 0, 1e-4f};
        CHECK(double(middle().g) == Approx(even_light(1, 0.03)).margin(0.01));
        // A wall a quarter of the way in.
        camera.position = {0, 0, 3};
        wall_m = 2.5f;
        CHECK(double(middle().g) == Approx(even_light(0.5, 0.03)).margin(0.01));
        // The eye behind it: nothing.
        camera.position = {0, 0, -3};
        camera.target = {0, 0, -9};
        wall_m = 0;
        CHECK(middle().g == 0);
        camera.target = {0, 0, 0};
    }
}

TEST_CASE_METHOD(OnVolume,
                 "a ball seen from 1,000 m, its rim on pixels: every one is a number, and the ball is there") {
    camera = {.position = {0.0f, 0.0f, 1000.0f}, .fov_y_rad = 0.0025f};
    for (const char* method : every_method) {
        volume.method.set(method);
        volume.shell.value = true;
        const ImageRgb seen = picture();
        CHECK(all_finite(seen));
        double sum = 0;
        for (const glm::vec3& pixel : seen.pixels) sum += double(pixel.g);
        CHECK(sum > 1);
    }
    // b² - c with floats: at 1,000 m the subtrahend has steps of 1/16, and a ball of 1 m is lost in them.
    const float b = 1000.0f, c = b * b - 1.0f;
    CHECK(std::fabs((b * b - c) - 1.0f) < 0.07f);
    CHECK(std::nextafter(b * b, 2e6f) - b * b == 0.0625f);
}

TEST_CASE_METHOD(OnVolume,
                 "an early exit at a transmittance of 0.01 loses 0.5 of a lamp of radiance 50 behind the volume",
                 "[16.early_exit]") {
    load({8, 8, 8}, [](int, int, int) { return 1.0f; });
    volume.transfer.set("even");
    volume.method.set("midpoint");
    volume.steps.value = 400;
    volume.glow.value = 0;
    background = {50, 50, 50, 1};
    // 0.0099 of the light gets through 2 m.
    volume.density.value = float(std::log(0.0099) / (200 * std::log(0.8)));
    volume.brightest.value = 60;
    CHECK(double(middle().g) == Approx(50 * 0.0099).epsilon(0.02));
    // Denser, so that the exit is met within: with the rule of thumb (0.002 / 0.2) the ray stops, and light of 1 % of 50
    // comes through that is not there.
    volume.density.value *= 2;
    const double right = double(middle().g);
    volume.brightest.value = 0.2f;
    const double early = double(middle().g);
    fmt::print("a lamp of 50 behind: {:.4f}, with an exit at T = 0.01 {:.4f}\n", right, early);
    CHECK(right < 0.01);
    CHECK(early > 0.4);
}

TEST_CASE("blocks without a border lose samples: of those that read something in a sparse volume a good part",
          "[figures][16.borders]") {
    // A sample reads 8 voxels; its block is that of the voxel it lies in.
    Random random(5);
    const int n = 64;
    std::vector<float> voxels(size_t(n * n * n), 0.0f);
    for (int blob = 0; blob < 40; ++blob) {
        const glm::ivec3 at(random.uniform(2, n - 3), random.uniform(2, n - 3), random.uniform(2, n - 3));
        for (int i = 0; i < 27; ++i) {
            const glm::ivec3 p = at + glm::ivec3(i % 3, i / 3 % 3, i / 9) - 1;
            voxels[size_t(p.x + n * (p.y + n * p.z))] = 1;
        }
    }
    const auto voxel = [&](glm::ivec3 p) {
        p = glm::clamp(p, glm::ivec3(0), glm::ivec3(n - 1));
        return voxels[size_t(p.x + n * (p.y + n * p.z))];
    };
    const auto is_empty = [&](glm::ivec3 block, int border) {
        for (int z = -border; z < BLOCK_VOXELS + border; ++z)
            for (int y = -border; y < BLOCK_VOXELS + border; ++y)
                for (int x = -border; x < BLOCK_VOXELS + border; ++x)
                    if (voxel(block * BLOCK_VOXELS + glm::ivec3(x, y, z)) > 0) return false;
        return true;
    };
    int reads = 0, lost[2] = {0, 0};
    for (int i = 0; i < 400000; ++i) {
        const glm::dvec3 at(random.uniform(0, n), random.uniform(0, n), random.uniform(0, n));
        const glm::ivec3 first(glm::floor(at - 0.5)), block(glm::floor(at / double(BLOCK_VOXELS)));
        float most = 0;
        for (int k = 0; k < 8; ++k) most = std::max(most, voxel(first + glm::ivec3(k & 1, k >> 1 & 1, k >> 2)));
        if (most == 0) continue;
        ++reads;
        for (const int border : {0, 1}) lost[border] += is_empty(block, border);
    }
    fmt::print("blocks of {}: without a border {:.1f}% of the samples that read something are lost, with one {}\n",
               BLOCK_VOXELS, 100.0 * lost[0] / reads, lost[1]);
    CHECK(lost[0] > 0.05 * reads);
    CHECK(lost[1] == 0);
}

TEST_CASE_METHOD(OnVolume, "skipping gives midpoint's picture to the last bit: a nebula, one voxel, none, and waves") {
    volume.steps.value = 64;
    const auto same = [&](const char* what) {
        INFO(what);
        volume.method.set("midpoint");
        const ImageRgb right = picture(1.5f);
        volume.method.set("skipping");
        CHECK(mean_difference(right, picture(1.5f)) == 0);
        return right;
    };
    same("nebula");
    volume.wave.value = 0.05f;
    same("waves");
    volume.transfer.set("even");
    load({19, 9, 33}, [](int x, int y, int z) { return x == 8 && y == 4 && z == 16 ? 1.0f : 0.0f; });
    same("one voxel and waves");
    volume.wave.value = 0;
    const ImageRgb one = same("one voxel");
    CHECK(one.pixels[size_t(size.y / 2) * size.x + size.x / 2].g > 0.0f);
    load({19, 9, 33}, [](int, int, int) { return 0.0f; });
    same("nothing");
    load({1, 1, 256}, [](int, int, int z) { return z % 2 ? 1.0f : 0.0f; });
    same("1 x 1 x 256");
}

TEST_CASE_METHOD(OnVolume, "an empty volume leaves the picture as it was, by every method") {
    load({8, 8, 8}, [](int, int, int) { return 0.0f; });
    background = {0.25f, 0.5f, 2, 1};
    for (const char* method : every_method)
        for (const char* transfer : {"even", "nebula", "skin"}) {
            volume.method.set(method);
            volume.transfer.set(transfer);
            for (const glm::vec3& pixel : picture().pixels) CHECK(pixel == glm::vec3(0.25f, 0.5f, 2));
        }
}

TEST_CASE_METHOD(OnVolume,
                 "one voxel that is NaN, one that is infinite, one below 0: no pixel is, nor its neighbours dark") {
    const auto plain = [](int, int, int) { return 0.5f; };
    volume.transfer.set("even");
    volume.density.value = 0.02f;
    load({16, 16, 16}, plain);
    for (const char* method : every_method) {
        volume.method.set(method);
        load({16, 16, 16}, plain);
        const ImageRgb right = picture();
        for (const float bad : {NAN, INFINITY, -INFINITY, -1.0f}) {
            INFO(method << " " << bad);
            load({16, 16, 16}, [&](int x, int y, int z) { return x == 8 && y == 8 && z == 8 ? bad : 0.5f; });
            for (const char* light : {"none", "volume"}) {
                volume.light.set(light);
                CHECK(all_finite(picture()));
            }
            volume.light.set("none");
            CHECK(mean_difference(right, picture()) < 0.002);
        }
    }
}

TEST_CASE_METHOD(OnVolume,
                 "jitter moves on from picture to picture, and their mean goes to the truth; what moves starts anew") {
    volume.steps.value = 12;
    volume.method.set("exact");
    const ImageRgb right = picture();
    volume.method.set("jittered");
    const ImageRgb first = picture();
    CHECK(volume.pictures(0) == 1);
    ImageRgb mean = first;
    for (int i = 1; i < 16; ++i) mean = picture();
    CHECK(volume.pictures(0) == 16);
    const double one = mean_difference(first, right), many = mean_difference(mean, right);
    fmt::print("12 jittered steps: off by {:.5f}, the mean of 16 pictures by {:.5f}\n", one, many);
    CHECK(many < 0.35 * one);
    // A pattern that stays on the screen while the camera moves is seen as a dirty pane: the first picture of another
    // view begins again, with the same number for each pixel, and the next has others.
    camera.position.x += 0.1f;
    picture();
    CHECK(volume.pictures(0) == 1);
    volume.glow.value = 2;
    picture();
    CHECK(volume.pictures(0) == 1);
    volume.wave.value = 0.01f;
    picture(1);
    picture(2);
    CHECK(volume.pictures(0) == 1);
}

TEST_CASE_METHOD(OnVolume, "light from a volume of half resolution is near that of a second march", "[16.half_light]") {
    volume.field.voxels.value = 96;
    volume.light.set("march");
    volume.light_steps.value = 24;
    volume.glow.value = 0;
    const ImageRgb right = picture();
    volume.light.set("volume");
    const double off = mean_difference(right, picture());
    double mean = 0;
    for (const glm::vec3& pixel : right.pixels)
        mean += double(pixel.r + pixel.g + pixel.b) / (3 * double(right.pixels.size()));
    fmt::print("light by a volume: {:.2f}% of the mean off\n", 100 * off / mean);
    CHECK(off < 0.05 * mean);
    volume.light.set("none");
    CHECK(mean_difference(right, picture()) > 0.5 * mean);
}
