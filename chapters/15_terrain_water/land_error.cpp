#include "15_terrain_water/land_error.h"

#include <algorithm>
#include <cstring>
#include <nlohmann/json.hpp>

#include "01_obj/camera_view.h"
#include "common/app/render.h"

namespace lightwalk {
namespace {

std::vector<float> found_by(Chapter& chapter, const Land& land, Gpu& gpu, glm::uvec2 size) {
    Frame own(gpu);
    render(chapter, own, {.size = size});
    render(chapter, own, {.size = size});  // the number of chunks arrives a frame later
    const auto bytes = gpu.read_back(land.found());
    std::vector<float> found(bytes.size() / sizeof(float));
    std::memcpy(found.data(), bytes.data(), bytes.size());
    return found;
}

}  // namespace

void measure_land(Chapter& chapter, Land& land, Gpu& gpu, glm::uvec2 size, nlohmann::json& error) {
    chapter.samples.value = 1;
    land.count = true;
    const std::vector<float> found = found_by(chapter, land, gpu, size);
    error["triangles"] = land.triangles();
    land.count = false;
    land.method.set("rays");
    const std::vector<float> truth = found_by(chapter, land, gpu, size);
    if (found.size() != truth.size() || found.size() != size_t(size.x) * size.y) return;

    const View view = view_of(chapter.camera, size);
    const ViewRays rays = view_rays(view);
    const auto point = [&](uint32_t x, uint32_t y) {
        return truth[size_t(y) * size.x + x] * ray_through(rays, glm::vec2(x, y) + 0.5f);
    };
    std::vector<double> off;
    size_t misjudged = 0;
    for (uint32_t y = 0; y + 1 < size.y; ++y)
        for (uint32_t x = 0; x + 1 < size.x; ++x) {
            const size_t i = size_t(y) * size.x + x;
            if ((found[i] > 0) != (truth[i] > 0)) ++misjudged;
            if (found[i] <= 0 || truth[i] <= 0 || truth[i + 1] <= 0 || truth[i + size.x] <= 0) continue;
            const glm::vec3 here = point(x, y);
            const glm::vec3 normal = glm::cross(point(x + 1, y) - here, point(x, y + 1) - here);
            if (glm::length(normal) <= 0) continue;
            const glm::vec3 moved = (found[i] - truth[i]) * ray_through(rays, glm::vec2(x, y) + 0.5f);
            off.push_back(double(std::fabs(glm::dot(moved, glm::normalize(normal)))) /
                          double(glm::length(here) * view.pixel_rad()));
        }
    error["misjudged"] = double(misjudged) / double(found.size());
    if (off.empty()) return;
    double sum = 0;
    for (const double value : off) sum += value;
    error["screen_error_px"] = sum / double(off.size());
    const auto rank = off.begin() + static_cast<std::ptrdiff_t>(0.99 * double(off.size() - 1));
    std::nth_element(off.begin(), rank, off.end());
    error["screen_error_p99_px"] = *rank;
}

}  // namespace lightwalk
