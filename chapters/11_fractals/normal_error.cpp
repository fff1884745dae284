#include "11_fractals/normal_error.h"

#if __has_include("11_fractals/truth.h")
#include <cstring>
#include <nlohmann/json.hpp>

#include "11_fractals/truth.h"
#include "common/app/read_picture.h"

namespace lightwalk {

void measure_normals(Gpu& gpu, const Terrain& terrain, const Frame& frame, nlohmann::json& error) {
    const std::vector<std::byte> bytes = gpu.read_back(frame.depth);
    std::vector<float> depths(bytes.size() / sizeof(float));
    std::memcpy(depths.data(), bytes.data(), bytes.size());
    const ImageRgb picture = read_linear(gpu, frame.hdr);
    const ViewRays rays = view_rays(terrain.from());
    const TerrainNow& now = terrain.now();
    constexpr double lacunarity = 2.23606797749978969;
    double sum = 0;
    int count = 0;
    for (uint32_t y = 2; y < frame.size.y; y += 5)
        for (uint32_t x = 2; x < frame.size.x; x += 5) {
            const float depth = depths[y * frame.size.x + x];
            if (depth <= 0) continue;
            const glm::dvec3 way =
                double(distance_along_view(rays, depth)) *
                glm::dvec3(ray_through(rays, {static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f}));
            const double most = double(terrain.most_octaves),
                         footprint = 0.5 * double(terrain.shortest_px * now.pixel_rad) * glm::length(way);
            const double octaves = terrain.octaves.is("fixed")
                                       ? most
                                       : truth::integrate_octaves(double(terrain.wave_m), lacunarity, footprint, most);
            const glm::dvec2 place(double(now.eye.x) + way.x, double(now.eye.z) + way.z);
            const NoisePlace there{now.cell, glm::dvec2(now.offset) + place / double(terrain.wave_m)};
            const glm::dvec2 slope =
                double(terrain.height_m) / double(terrain.wave_m) *
                truth::eroded_truth(there, octaves, double(terrain.erosion), double(terrain.gain)).slope;
            const glm::dvec3 right = glm::normalize(glm::dvec3(-slope.x, 1, -slope.y));
            const glm::dvec3 found = glm::normalize(2.0 * glm::dvec3(picture.at(int(x), int(y))) - 1.0);
            sum += glm::degrees(std::acos(std::clamp(glm::dot(right, found), -1.0, 1.0)));
            ++count;
        }
    if (count > 0) error["normal_deg"] = sum / count;
}

}  // namespace lightwalk

#else  // a handout: there is nothing to measure against

namespace lightwalk {

void measure_normals(Gpu&, const Terrain&, const Frame&, nlohmann::json&) {}

}  // namespace lightwalk

#endif
