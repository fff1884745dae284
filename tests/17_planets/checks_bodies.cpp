// Checks of chapter 17's functions in C++.
#include <fmt/core.h>

#include <cmath>

#include "17_planets/exercises.h"
#include "common/check/check.h"

using namespace lightwalk;

CHECK_EXERCISE("17.camera_relative", "subtract in double precision, then round to floats") {
    Random random(7);
    for (int i = 0; i < 60; ++i) {
        const double away = i < 10 ? 1.0 : random.logarithmic(1, 1e12),
                     sun = i % 3 ? 4.5e12 : random.logarithmic(1e9, 1e13);
        const glm::dvec3 camera = sun * glm::dvec3(random.direction());
        const glm::dvec3 offset = away * glm::dvec3(random.direction());
        const glm::dvec3 x(random.direction()), y = glm::normalize(glm::cross(x, glm::dvec3(random.direction())));
        glm::dmat4 matrix(1.0);
        const double scale = random.uniform(0.5, 2);
        matrix[0] = glm::dvec4(scale * x, 0), matrix[1] = glm::dvec4(y, 0), matrix[2] = glm::dvec4(glm::cross(x, y), 0);
        matrix[3] = glm::dvec4(camera + offset, 1);
        const glm::dvec3 right = glm::dvec3(matrix[3]) - camera;  // exact content of the doubles
        const std::string what =
            fmt::format("camera_relative(a body {:.4g} m before a camera {:.4g} m from the Sun)", away, sun);
        check.call(what, [&]() -> std::string {
            const glm::mat4 got = camera_relative(matrix, camera);
            const double error = glm::length(glm::dvec3(glm::vec3(got[3])) - right);
            if (!(error <= std::max(1e-7 * glm::length(right), 1e-9)))
                return fmt::format("{} is {:.4g} m off: {}", what, error,
                                   error > 0.9 * sun ? "the camera is not subtracted"
                                   : error > 1.9 * away && error < 2.1 * away
                                       ? "it lies on the other side: the body minus the camera"
                                       : "the numbers were floats before they were subtracted");
            for (int c = 0; c < 3; ++c)
                for (int r = 0; r < 3; ++r)
                    if (!(std::fabs(static_cast<double>(got[c][r]) - matrix[c][r]) < 1e-6))
                        return fmt::format("{}: column {} is another axis: axes and scales stay as they are", what, c);
            for (int c = 0; c < 4; ++c)
                if (got[c][3] != (c == 3 ? 1.0f : 0.0f)) return fmt::format("{}: row 3 must stay (0, 0, 0, 1)", what);
            return "";
        });
        if (check.failed) return;
    }
}

namespace {

// The spec, word for word, without any haste.
std::vector<glm::dvec3> slow_normals(int width, int height, const std::vector<float>& map, int octaves, double slope) {
    const auto blur = [&](int r) {
        const auto along = [&](const std::vector<double>& from, bool rows) {
            std::vector<double> to(from.size());
            for (int y = 0; y < height; ++y)
                for (int x = 0; x < width; ++x) {
                    double sum = 0;
                    for (int i = -r; i <= r; ++i) {
                        const int xi = rows ? ((x + i) % width + width) % width : x,
                                  yi = rows ? y : std::clamp(y + i, 0, height - 1);
                        sum += from[size_t(yi * width + xi)];
                    }
                    to[size_t(y * width + x)] = sum / (2 * r + 1);
                }
            return to;
        };
        return along(along({map.begin(), map.end()}, true), false);
    };
    std::vector<double> fine(map.begin(), map.end()), heights(map.size(), 0.0);
    for (int i = 0; i < octaves; ++i) {
        const std::vector<double> coarse = blur(1 << i);
        double sum = 0, squares = 0;
        for (size_t k = 0; k < fine.size(); ++k)
            sum += fine[k] - coarse[k], squares += (fine[k] - coarse[k]) * (fine[k] - coarse[k]);
        const double n = double(fine.size()), deviation = std::sqrt(std::max(0.0, squares / n - sum / n * sum / n));
        for (size_t k = 0; k < fine.size() && deviation > 1e-9; ++k)
            heights[k] += (1 << i) * (fine[k] - coarse[k]) / deviation;
        fine = coarse;
    }
    std::vector<glm::dvec3> normals;
    const auto at = [&](int x, int y) {
        return heights[size_t(std::clamp(y, 0, height - 1) * width + (x + width) % width)];
    };
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            normals.push_back(glm::normalize(glm::dvec3(-0.5 * slope / octaves * (at(x + 1, y) - at(x - 1, y)),
                                                        -0.5 * slope / octaves * (at(x, y - 1) - at(x, y + 1)), 1)));
    return normals;
}

}  // namespace

CHECK_EXERCISE("17.overlay_normals",
               "octaves are differences of blurred maps; each is divided by its deviation and multiplied by 2^i") {
    Random random(8);
    for (int kind = 0; kind < 6; ++kind) {
        const int width = kind == 4 ? 40 : 64, height = kind == 4 ? 24 : 32,
                  octaves = kind == 5   ? 1
                            : kind == 3 ? 2
                                        : 4;
        std::vector<float> map;
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x)
                map.push_back(kind == 0   ? 0.5f
                              : kind == 1 ? float(x < 8 || x > 40)
                              : kind == 2 ? float(y) / float(height)
                                          : float(random.uniform(0, 1)));
        const double slope = kind == 3 ? 0.3 : 1;
        const char* kinds[] = {
            "an even map",    "a bright band across the date line", "a map that darkens to the north", "noise", "noise",
            "noise, 1 octave"};
        const std::string what =
            fmt::format("overlay_normals({} x {}, {}, {} octaves)", width, height, kinds[kind], octaves);
        check.call(what, [&]() -> std::string {
            const auto got = overlay_normals(width, height, map, octaves, float(slope));
            if (got.size() != map.size())
                return fmt::format("{} gave {} normals, expected {}", what, got.size(), map.size());
            const auto right = slow_normals(width, height, map, octaves, slope);
            for (size_t i = 0; i < got.size(); ++i) {
                const double error = glm::length(glm::dvec3(got[i]) - right[i]);
                if (error < 2e-3) continue;
                const int x = int(i) % width, y = int(i) / width;
                const glm::dvec3 g(got[i]);
                return fmt::format("{} gave ({:.3f}, {:.3f}, {:.3f}) at ({}, {}), expected ({:.3f}, {:.3f}, {:.3f}){}",
                                   what, g.x, g.y, g.z, x, y, right[i].x, right[i].y, right[i].z,
                                   std::fabs(right[i].y) > 0.01 && std::fabs(g.y + right[i].y) < 1e-3 &&
                                           std::fabs(g.x - right[i].x) < 1e-3
                                       ? ": north is up, row y - 1"
                                   : std::fabs(right[i].x) > 0.01 && std::fabs(g.x + right[i].x) < 1e-3
                                       ? ": a slope that rises to the east leans to the west"
                                   : x == 0 || x == width - 1  ? ": x goes around the planet"
                                   : y == 0 || y == height - 1 ? ": columns end at the poles"
                                                               : "");
            }
            return "";
        });
        if (check.failed) return;
    }
}
