// Shared by the tests of the ground: a map, its methods, and their results.
#pragma once
#include <zlib.h>

#include <filesystem>
#include <fstream>

#include "../common/module_fixture.h"
#include "01_obj/camera_view.h"
#include "15_terrain_water/land.h"

namespace lightwalk {

/// A grey PNG of 8 or 16 bits, `value(x, y)` of 0 to 1.
template <class Value>
std::filesystem::path write_grey(const std::string& name, uint32_t width, uint32_t height, int bits,
                                 const Value& value) {
    std::string rows;
    for (uint32_t y = 0; y < height; ++y) {
        rows += '\0';
        for (uint32_t x = 0; x < width; ++x) {
            const auto code = static_cast<uint32_t>(std::lround(double(value(x, y)) * (bits == 16 ? 65535 : 255)));
            if (bits == 16) rows += static_cast<char>(code >> 8);
            rows += static_cast<char>(code & 255);
        }
    }
    std::string packed(compressBound(rows.size()), '\0');
    uLongf length = packed.size();
    compress(reinterpret_cast<Bytef*>(packed.data()), &length, reinterpret_cast<const Bytef*>(rows.data()),
             rows.size());
    packed.resize(length);
    const auto number = [](uint32_t n) {
        return std::string{char(n >> 24), char(n >> 16 & 255), char(n >> 8 & 255), char(n & 255)};
    };
    const auto chunk = [&](const std::string& type, const std::string& data) {
        const std::string body = type + data;
        const auto crc = crc32(0, reinterpret_cast<const Bytef*>(body.data()), uInt(body.size()));
        return number(uint32_t(data.size())) + body + number(uint32_t(crc));
    };
    const std::string header = number(width) + number(height) + char(bits) + std::string(4, '\0');
    const std::filesystem::path file = std::filesystem::temp_directory_path() / name;
    std::ofstream(file, std::ios::binary) << "\x89PNG\r\n\x1a\n"
                                          << chunk("IHDR", header) << chunk("IDAT", packed) << chunk("IEND", "");
    return file;
}

struct OnLand : OnModules {
    Atmosphere atmosphere{owner, "atmosphere"};
    Ground ground{owner, "ground"};
    Land land{owner, "land", ground, atmosphere};
    Scene scene;
    Camera camera{.position = {0, 600, 0}, .target = {1000, 0, 600}, .fov_y_rad = 0.8f, .near_m = 1, .far_m = 1e5f};
    glm::uvec2 size{64, 40};

    explicit OnLand(const std::filesystem::path& map = "terrain/jacksboro_dem.png") {
        ground.levels.value = 8;
        ground.span_km.value = 8;
        ground.center_x_km.value = -5;
        ground.datum_m.value = 380;
        ground.height_scale.value = 1.5f;
        ground.detail_m.value = 60;
        load(map);
    }
    void load(const std::filesystem::path& map) {
        scene.file.objects = {SceneObject{.name = "ground", .parent = {}, .model = map}};
        owner.prepare_all(gpu, scene);
    }

    /// Distances along the view of every pixel, row by row; 0: no ground.
    std::vector<float> found(const char* method) {
        land.method.set(method);
        begin(size);
        atmosphere.update_once(frame);
        Canvas canvas(frame.hdr, frame.depth);
        lightwalk::draw(frame, view_of(camera, size), canvas, {land});
        frame.end();
        const auto bytes = gpu.read_back(land.found());
        std::vector<float> all(bytes.size() / 4);
        std::memcpy(all.data(), bytes.data(), bytes.size());
        return all;
    }
};

}  // namespace lightwalk
