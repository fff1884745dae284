#include "11_fractals/errors.h"

#if __has_include("11_fractals/truth.h")
#include <cstring>
#include <nlohmann/json.hpp>

#include "01_obj/camera_view.h"
#include "11_fractals/truth.h"
#include "common/app/read_picture.h"

namespace lightwalk {
namespace {

constexpr int columns = 48, rows = 27;
constexpr double most_m = 0.1;

}  // namespace

void DepthError::measure(Gpu& gpu, const Julia& julia, const Camera& camera, double time_s, nlohmann::json& error) {
    const glm::uvec2 size(julia.found.desc.size);
    const std::vector<std::byte> bytes = gpu.read_back(julia.found);
    std::vector<glm::vec4> found(bytes.size() / sizeof(glm::vec4));
    std::memcpy(found.data(), bytes.data(), bytes.size());

    const ViewRays rays = view_rays(view_of(camera, size));
    const truth::JuliaRay exact{.c = glm::dvec4(julia.constant_at(time_s)), .slice = double(julia.slice)};
    const double bound = double(julia_bound(glm::vec4(exact.c)));
    const auto direction = [&](double x, double y) {
        return glm::normalize(glm::dvec3(rays.corner) + (x + 0.5) * glm::dvec3(rays.right) +
                              (y + 0.5) * glm::dvec3(rays.down));
    };

    double steps = 0, met = 0, capped = 0;
    for (uint32_t y = 0; y < size.y; ++y)
        for (uint32_t x = 0; x < size.x; ++x) {
            const glm::dvec2 range = truth::within_ball(glm::dvec3(rays.eye), direction(x, y), bound);
            if (range.x > range.y) continue;
            const glm::vec4& march = found[y * size.x + x];
            met += 1;
            steps += double(march.y);
            capped += march.z == 2;
        }

    nlohmann::json key{size.x, size.y, time_s, exact.slice};
    for (int i = 0; i < 3; ++i) {
        key.push_back(camera.position[i]);
        key.push_back(camera.target[i]);
    }
    for (int i = 0; i < 4; ++i) key.push_back(exact.c[i]);
    std::vector<double>& depths = known_[key.dump()];
    const bool fresh = depths.empty();
    double sum = 0, misjudged = 0, judged = 0;
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            const glm::uvec2 pixel((2 * column + 1) * size.x / (2 * columns), (2 * row + 1) * size.y / (2 * rows));
            if (fresh) {
                const glm::dvec3 from(rays.eye), along = direction(pixel.x, pixel.y);
                const glm::dvec2 range = truth::within_ball(from, along, bound);
                depths.push_back(range.x < range.y ? truth::julia_depth(exact, from, along, range.x, range.y) : -1);
            }
            const double right = depths[static_cast<size_t>(row * columns + column)];
            const glm::vec4& march = found[pixel.y * size.x + pixel.x];
            const bool hits = march.z != 0;
            if (!hits && right < 0) continue;
            judged += 1;
            misjudged += hits != (right >= 0);
            sum += hits == (right >= 0) ? std::min(std::fabs(double(march.x) - right), most_m) : most_m;
        }
    error["depth_error"] = judged > 0 ? sum / judged : 0;
    error["misjudged"] = judged > 0 ? misjudged / judged : 0;
    error["evaluations"] = met > 0 ? steps / met : 0;
    error["capped"] = met > 0 ? capped / met : 0;
}

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

void DepthError::measure(Gpu&, const Julia&, const Camera&, double, nlohmann::json&) {}

void measure_normals(Gpu&, const Terrain&, const Frame&, nlohmann::json&) {}

}  // namespace lightwalk

#endif
