// The bound of chunks: no point is drawn further from the ground than land.error_px, nor is a skyline.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "common/check/probe.h"
#include "land_fixture.h"

using namespace lightwalk;

namespace {

double squared_distance(glm::dvec3 p, glm::dvec3 a, glm::dvec3 b) {
    const double t = std::clamp(glm::dot(p - a, b - a) / glm::dot(b - a, b - a), 0.0, 1.0);
    const glm::dvec3 off = p - a - t * (b - a);
    return glm::dot(off, off);
}

/// To a triangle.
double distance_to(glm::dvec3 p, glm::dvec3 a, glm::dvec3 b, glm::dvec3 c) {
    const glm::dvec3 normal = glm::normalize(glm::cross(b - a, c - a));
    const double off = glm::dot(p - a, normal);
    const auto inside = [&](glm::dvec3 from, glm::dvec3 to) {
        return glm::dot(glm::cross(to - from, p - from), normal) >= 0;
    };
    if (inside(a, b) && inside(b, c) && inside(c, a)) return std::fabs(off);
    return std::sqrt(std::min({squared_distance(p, a, b), squared_distance(p, b, c), squared_distance(p, c, a)}));
}

/// The finest ground.
struct Heights {
    std::vector<float> all;
    LandMap map;

    glm::dvec3 point(int x, int z) const {
        return {double(map.corner.x) + double(map.spacing_m) * x, all[size_t(z) * size_t(map.samples) + size_t(x)],
                double(map.corner.y) + double(map.spacing_m) * z};
    }
    /// From a point to the nearest triangle, or `most` if none is as near.
    double distance(glm::dvec3 p, double most) const {
        const double spacing = double(map.spacing_m);
        const auto cell = [&](double at, double corner) {
            return std::clamp(int(std::floor((at - corner) / spacing)), 0, map.samples - 2);
        };
        for (int z = cell(p.z - most, double(map.corner.y)); z <= cell(p.z + most, double(map.corner.y)); ++z)
            for (int x = cell(p.x - most, double(map.corner.x)); x <= cell(p.x + most, double(map.corner.x)); ++x) {
                const glm::dvec3 b = point(x + 1, z), c = point(x, z + 1);
                most = std::min({most, distance_to(p, point(x, z), b, c), distance_to(p, point(x + 1, z + 1), b, c)});
            }
        return most;
    }
};

/// Random views from above the ground, each with an error of its own.
struct OnViews : OnLand {
    Random random{43};
    Heights heights;
    View view;

    OnViews() {
        found("chunks");
        const auto bytes = gpu.read_back(ground.heights().mip(0));
        heights = {std::vector<float>(bytes.size() / sizeof(float)), ground.map()};
        std::memcpy(heights.all.data(), bytes.data(), bytes.size());
        camera.fov_y_rad = 0.6f;
    }
    void next(double lowest_down, double highest_m, double most_px) {
        const int last = ground.map().samples - 1;
        const glm::vec3 under(
            heights.point(int(random.uniform(0.2, 0.8) * last), int(random.uniform(0.2, 0.8) * last)));
        const double around = random.uniform(0, 6.28), down = random.uniform(lowest_down, lowest_down + 0.7);
        camera.position = under + glm::vec3(0, random.uniform(60, highest_m), 0);
        camera.target = camera.position + glm::vec3(std::cos(around), -std::tan(down), std::sin(around));
        land.error_px.value = float(random.logarithmic(1, most_px));
        view = view_of(camera, size);
    }
};

/// Pixels from the ground of one picture to the nearest of another, the largest; more than `most` counts as twice that.
/// Without a border of that width, whose nearest may be out of the picture.
double furthest(const std::vector<float>& from, const std::vector<float>& to, glm::ivec2 size, int most) {
    double worst = 0;
    for (int y = most; y < size.y - most; ++y)
        for (int x = most; x < size.x - most; ++x) {
            if (from[size_t(y * size.x + x)] <= 0) continue;
            double nearest = 2.0 * most;
            for (int v = y - most; v <= y + most; ++v)
                for (int u = x - most; u <= x + most; ++u)
                    if (to[size_t(v * size.x + u)] > 0) nearest = std::min(nearest, std::hypot(u - x, v - y));
            worst = std::max(worst, nearest);
        }
    return worst;
}

}  // namespace

TEST_CASE_METHOD(OnViews, "chunks are drawn within land.error_px of the ground", "[15.bound]") {
    double worst = 0;
    size_t pixels = 0;
    for (int i = 0; i < 24; ++i) {
        next(0.05, 800, 8);
        const std::vector<float> drawn = found("chunks");
        const ViewRays rays = view_rays(view);
        for (uint32_t p = 0; p < drawn.size(); ++p) {
            if (drawn[p] <= 0) continue;
            const glm::vec2 pixel(float(p % size.x) + 0.5f, float(p / size.x) + 0.5f);
            const glm::dvec3 way = double(drawn[p]) * glm::dvec3(ray_through(rays, pixel));
            const double allowed = glm::length(way) * double(view.pixel_rad() * land.error_px);
            worst = std::max(worst, heights.distance(glm::dvec3(view.eye) + way, 4 * allowed) / allowed);
            ++pixels;
        }
    }
    fmt::print("{} pixels of ground; the largest error is {:.2f} of land.error_px\n", pixels, worst);
    CHECK(worst < 1);
    CHECK(worst > 0.5);
    CHECK(pixels > 40'000);
}

TEST_CASE_METHOD(OnViews, "above a ridge that is drawn too low, a pixel of chunks shows ground far behind it",
                 "[15.behind_ridges]") {
    double farthest = 0;
    for (int i = 0; i < 24; ++i) {
        next(0.05, 800, 8);
        const std::vector<float> drawn = found("chunks"), truth = found("rays");
        for (size_t p = 0; p < drawn.size(); ++p)
            if (drawn[p] > 0 && truth[p] > 0) farthest = std::max(farthest, double(drawn[p]) / double(truth[p]));
    }
    fmt::print("a pixel shows ground {:.1f} times as far away as it should\n", farthest);
    CHECK(farthest > 1.3);
}

TEST_CASE_METHOD(OnViews, "the skyline of chunks is within land.error_px of that of rays", "[15.bound]") {
    size = {128, 80};
    double worst = 0;
    int skylines = 0;
    for (int i = 0; i < 16; ++i) {
        next(-0.35, 300, 3);
        const std::vector<float> drawn = found("chunks"), truth = found("rays");
        // A pixel off the middle covers a smaller angle; and each outline is rounded to pixels.
        const double most = double(land.error_px) * (1 + std::pow(std::tan(0.3) * std::hypot(1.0, 1.6), 2)) + 1.5;
        const int search = int(1.5 * most) + 1;
        const double off = std::max(furthest(drawn, truth, size, search), furthest(truth, drawn, size, search));
        INFO(i << ": " << off << " pixels, allowed " << most);
        CHECK(off <= most);
        worst = std::max(worst, (off - 1.5) / double(land.error_px));
        skylines += off > 0;
    }
    fmt::print("{} skylines differ; the largest difference is {:.2f} of land.error_px\n", skylines, worst);
    CHECK(skylines > 10);
}
