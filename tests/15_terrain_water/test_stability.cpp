// Where the ground fails, or must not: cracks, heights of few bits, odd maps, the far plane, and files that are no maps.
#include <fmt/core.h>

#include <cmath>
#include <cstring>
#include <glm/gtc/packing.hpp>

#include "common/base/error.h"
#include "common/check/probe.h"
#include "land_fixture.h"

using namespace lightwalk;

namespace {

std::string error_of(const std::filesystem::path& file) {
    try {
        read_height_map(file);
    } catch (const InputError& error) { return error.what(); }
    return "";
}

std::vector<glm::vec3> normals_of(OnLand& on) {
    on.found("chunks");
    const auto bytes = on.gpu.read_back(on.ground.slopes().mip(0));
    std::vector<glm::vec3> all;
    for (size_t i = 0; i + 8 <= bytes.size(); i += 8) {
        uint64_t texel = 0;
        std::memcpy(&texel, bytes.data() + i, 8);
        const glm::vec4 slope = glm::unpackHalf4x16(texel);
        all.push_back(glm::normalize(glm::vec3(-slope.x, 1, -slope.y)));
    }
    return all;
}

double mean_angle_deg(const std::vector<glm::vec3>& a, const std::vector<glm::vec3>& b) {
    double sum = 0;
    for (size_t i = 0; i < a.size(); ++i) sum += std::asin(std::min(1.0, double(glm::length(glm::cross(a[i], b[i])))));
    return sum / double(a.size()) * 180 / M_PI;
}

// A slope of 100 m over 256 samples that lie 1 m apart, with hills.
double hills(uint32_t x, uint32_t y) {
    return 0.5 + 0.25 * std::sin(x * 0.05) * std::cos(y * 0.043) + 0.2 * std::sin(x * 0.021 + y * 0.017);
}

}  // namespace

TEST_CASE_METHOD(OnLand, "no sky shows through the ground in 200 views, by any method", "[15.no_holes]") {
    Random random(21);
    size_t holes = 0, pixels = 0;
    camera.fov_y_rad = 0.6f;  // steeply down from above all mountains: every ray ends on the map
    for (int i = 0; i < 200; ++i) {
        camera.position = {random.uniform(-800, 800), random.uniform(1250, 1700), random.uniform(-800, 800)};
        const double around = random.uniform(0, 6.28), down = random.uniform(1.0, 1.4);
        camera.target = camera.position + glm::vec3(std::cos(around), -std::tan(down), std::sin(around));
        land.error_px.value = float(random.logarithmic(0.5, 16));
        const char* const methods[] = {"chunks", "chunks", "chunks", "rings", "rays"};
        for (const float t : found(methods[i % 5])) {
            holes += t <= 0;
            ++pixels;
        }
    }
    INFO(holes << " of " << pixels << " pixels");
    CHECK(holes == 0);
}

TEST_CASE_METHOD(OnLand, "the finest grid is where rays end, and chunks keep to their error") {
    for (const float degrees : {10.0f, 130.0f, 250.0f}) {
        const float a = glm::radians(degrees);
        camera.target = camera.position + glm::vec3(std::cos(a), -0.7f, std::sin(a));
        const std::vector<float> truth = found("rays");
        land.grid_level.value = 0;
        land.error_px.value = 2;
        const std::vector<float> grid = found("grid"), chunks = found("chunks");
        double worst = 0, off = 0;
        for (size_t i = 0; i < truth.size(); ++i) {
            worst = std::max(worst, std::fabs(double(grid[i]) / double(truth[i]) - 1));
            off += std::fabs(double(chunks[i]) / double(truth[i]) - 1);
        }
        CHECK(worst < 0.02);  // at a ridge's edge the pixel's middle decides
        CHECK(off / double(truth.size()) < 0.01);
    }
}

TEST_CASE_METHOD(OnLand, "the far plane changes nothing of the ground", "[15.far_plane]") {
    const std::vector<float> near = found("chunks");
    camera.far_m = 1e9f;
    const std::vector<float> far = found("chunks");
    for (size_t i = 0; i < near.size(); ++i) REQUIRE(std::fabs(near[i] - far[i]) <= 1e-3f * near[i]);
}

TEST_CASE("heights of 8 bits bend the normals, of 16 hardly", "[15.height_bits]") {
    const auto file = write_grey("lightwalk_hills.png", 257, 257, 16, hills);
    std::ofstream(std::filesystem::path(file).replace_extension(".json"))
        << R"({"min_elevation_m": 0, "max_elevation_m": 100, "metres_per_sample_x": 1, "metres_per_sample_y": 1})";
    const auto with = [&](const char* bits) {
        OnLand on;
        on.ground.span_km.value = 0;
        on.ground.center_x_km.value = 0;
        on.ground.datum_m.value = 0;
        on.ground.height_scale.value = 1;
        on.ground.detail_m.value = 0;
        on.ground.precision.set(bits);
        on.load(file);
        return normals_of(on);
    };
    const auto truth = with("float");
    const double eight = mean_angle_deg(with("8"), truth), twelve = mean_angle_deg(with("12"), truth);
    const double sixteen = mean_angle_deg(with("16"), truth);
    INFO(eight << " " << twelve << " " << sixteen);
    CHECK((eight > 2.5 && eight < 8));
    CHECK((twelve > 0.12 && twelve < 0.6));
    CHECK(sixteen < 0.05);
    std::filesystem::remove(file);
    std::filesystem::remove(std::filesystem::path(file).replace_extension(".json"));
}

TEST_CASE("maps of odd sizes are ground, the smallest too", "[15.odd_maps]") {
    for (const glm::uvec2 map_size : {glm::uvec2(2, 2), glm::uvec2(3, 5), glm::uvec2(17, 2), glm::uvec2(101, 67)}) {
        const auto file = write_grey("lightwalk_odd.png", map_size.x, map_size.y, 8,
                                     [](uint32_t x, uint32_t y) { return ((x * 7 + y * 3) % 5) / 5.0; });
        OnLand on(file);
        on.ground.span_km.value = 2;
        on.ground.center_x_km.value = 0;
        on.ground.datum_m.value = 500;
        on.camera.position = {0, 3000, 0};
        on.camera.target = {1, 0, 1};
        on.camera.fov_y_rad = 0.3f;
        for (const char* method : {"grid", "rings", "chunks", "rays"})
            for (const float t : on.found(method)) REQUIRE((t > 100 && t < 6000));
        std::filesystem::remove(file);
    }
}

TEST_CASE("what is no height map is refused in one line", "[15.refused_maps]") {
    const auto refused = [](const std::filesystem::path& file, const std::string& why) {
        const std::string text = error_of(file);
        INFO(text);
        CHECK(text.find(why) != std::string::npos);
        CHECK(text.find('\n') == std::string::npos);
    };
    refused(find_asset("textures/stone_tiles_albedo.jpg"), "3 channels");
    refused(find_asset("terrain/jacksboro_dem.json"), "expected");
    const auto one = write_grey("lightwalk_one.png", 1, 1, 16, [](auto, auto) { return 0.5; });
    refused(one, "at least 2x2");
    std::filesystem::remove(one);
    const auto huge = write_grey("lightwalk_huge.png", 2, 2, 16, [](auto, auto) { return 0.5; });
    {
        std::fstream header(huge, std::ios::in | std::ios::out | std::ios::binary);
        header.seekp(16);
        header.write("\x00\x01\x86\xa0\x00\x01\x86\xa0", 8);  // 100,000 x 100,000
    }
    refused(huge, "lightwalk_huge.png");
    std::filesystem::remove(huge);
    refused("/no/such/map.png", "map.png");
}
