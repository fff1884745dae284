#include "11_fractals/depth_error.h"

#if __has_include("11_fractals/truth.h")
#include <cstring>
#include <nlohmann/json.hpp>

#include "01_obj/camera_view.h"
#include "11_fractals/truth.h"

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

}  // namespace lightwalk

#else  // a handout: there is nothing to measure against

namespace lightwalk {

void DepthError::measure(Gpu&, const Julia&, const Camera&, double, nlohmann::json&) {}

}  // namespace lightwalk

#endif
