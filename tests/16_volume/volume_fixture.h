// Shared by the tests of volumes: the module on a device, and volumes in files with known light.
#pragma once
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "../common/gpu_fixture.h"
#include "01_obj/camera_view.h"
#include "16_volume/truth.h"
#include "16_volume/volume.h"
#include "common/app/read_picture.h"
#include "common/check/probe.h"

namespace lightwalk {

/// A folder of its own, gone at the end.
struct Folder {
    std::filesystem::path path =
        std::filesystem::temp_directory_path() / ("lightwalk_volume_" + std::to_string(getpid()));
    Folder() { std::filesystem::create_directories(path); }
    ~Folder() { std::filesystem::remove_all(path); }
    std::filesystem::path write(const std::string& name, const std::string& text) const {
        std::ofstream(path / name, std::ios::binary) << text;
        return path / name;
    }
};

struct OnVolume {
    struct Owner : Module {
    } owner;
    Volume volume{owner, "volume"};
    Scene scene;
    Camera camera{.position = {0.0f, 0.0f, 3.0f}, .fov_y_rad = 0.6f};
    Gpu& gpu = validated_device();
    Frame frame{gpu};
    Folder folder;
    glm::uvec2 size{48, 32};
    glm::vec4 background{0, 0, 0, 1};
    float wall_m = 0;  ///< along the view; 0: none

    OnVolume() {
        volume.field.voxels.value = 32;
        volume.light.set("none");
        volume.shell.value = false;
        volume.glow.value = 1;
        owner.prepare_all(gpu, scene);
    }
    ~OnVolume() { CHECK_NOTHROW(gpu.device.check_validation()); }

    /// Even matter that sends nothing but sunlight, finely sampled.
    void in_sunlight() {
        volume.transfer.set("even");
        volume.method.set("midpoint");
        volume.steps.value = 512;
        volume.glow.value = 0;
        volume.light.set("march");
        volume.light_from.set("sun");
    }

    /// A volume of `dims` voxels, each value(x, y, z), stored as floats.
    template <class Value>
    void load(glm::ivec3 dims, const Value& value) {
        std::string bytes;
        for (int z = 0; z < dims.z; ++z)
            for (int y = 0; y < dims.y; ++y)
                for (int x = 0; x < dims.x; ++x) {
                    const float one = value(x, y, z);
                    bytes.append(reinterpret_cast<const char*>(&one), 4);
                }
        folder.write("test.raw", bytes);
        const std::string header = "{\"file\": \"test.raw\", \"dtype\": \"float32\", \"dims\": [" +
                                   std::to_string(dims.x) + ", " + std::to_string(dims.y) + ", " +
                                   std::to_string(dims.z) + "]}";
        scene.file.objects.clear();
        scene.file.objects.push_back({.name = "volume", .parent = "", .model = folder.write("test.volume", header)});
        owner.prepare_all(gpu, scene);
    }

    void draw(float time_s = 0) {
        owner.begin_frame(gpu, size);
        frame.begin(size, time_s);
        Canvas canvas(frame.hdr, frame.depth, background);
        const View view = view_of(camera, size);
        if (wall_m > 0) {
            const ViewRays rays = view_rays(view);
            canvas.depth_overwritten();
            const float depth = (1 / wall_m - rays.inverse_far) / (rays.inverse_near - rays.inverse_far);
            frame.raster("wall", {.depth = clear(frame.depth, depth)}, [](Raster&) {});
        }
        lightwalk::draw(frame, view, canvas, {volume});
        frame.end();
    }
    ImageRgb picture(float time_s = 0) {
        draw(time_s);
        return read_linear(gpu, frame.hdr);
    }
    /// The pixel right of and below the picture's middle.
    glm::vec3 middle() { return picture().pixels[size_t(size.y / 2) * size.x + size.x / 2]; }
};

/// Of the transfer function `even` at density 1: the opacity of 0.01 m, and emission and transmittance of a path.
constexpr double even_opacity = 0.2;
inline double even_light(double way_m, double density) {
    return truth::correct_opacity(even_opacity, density * way_m / double(REFERENCE_M));
}

/// The mean difference of all channels.
inline double mean_difference(const ImageRgb& a, const ImageRgb& b) {
    double sum = 0;
    for (size_t i = 0; i < a.pixels.size(); ++i)
        for (int c = 0; c < 3; ++c) sum += std::fabs(double(a.pixels[i][c]) - double(b.pixels[i][c]));
    return sum / (3 * double(a.pixels.size()));
}

inline bool all_finite(const ImageRgb& picture) {
    for (const glm::vec3& pixel : picture.pixels)
        if (!std::isfinite(pixel.r + pixel.g + pixel.b)) return false;
    return true;
}

inline const char* const every_method[] = {"sum",      "trapezium",     "midpoint", "jittered",
                                           "skipping", "preintegrated", "exact"};

}  // namespace lightwalk
