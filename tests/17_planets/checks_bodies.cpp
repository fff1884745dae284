// Checks of chapter 17's functions in C++.
#include <fmt/core.h>

#include <cmath>
#include <functional>

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
        matrix[0] = glm::dvec4(scale * x, 0);
        matrix[1] = glm::dvec4(0.75 * y, 0);
        matrix[2] = glm::dvec4(1.5 * glm::cross(x, y), 0);
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

// The mistakes that are told by name, and none.
enum class Slip { none, clamped_x, wrapped_y, even, mean, size, octave_0, south, downhill, per_octave, half };

// The spec, word for word, without any haste.
std::vector<glm::dvec3> slow_normals(int width, int height, const std::vector<float>& map, int octaves, double slope,
                                     Slip slip = Slip::none) {
    const auto wrapped = [](int i, int n) { return (i % n + n) % n; };
    const auto column = [&](int x) {
        return slip == Slip::clamped_x ? std::clamp(x, 0, width - 1) : wrapped(x, width);
    };
    const auto row = [&](int y) { return slip == Slip::wrapped_y ? wrapped(y, height) : std::clamp(y, 0, height - 1); };
    const auto blur = [&](int r) {
        const auto along = [&](const std::vector<double>& from, bool rows) {
            std::vector<double> to(from.size());
            for (int y = 0; y < height; ++y)
                for (int x = 0; x < width; ++x) {
                    double sum = 0;
                    for (int i = -r; i <= r; ++i)
                        sum += from[size_t((rows ? y : row(y + i)) * width + (rows ? column(x + i) : x))];
                    to[size_t(y * width + x)] = sum / (2 * r + 1);
                }
            return to;
        };
        return along(along({map.begin(), map.end()}, true), false);
    };
    std::vector<double> fine(map.begin(), map.end()), heights(map.size(), 0.0);
    for (int i = 0; i < (slip == Slip::octave_0 ? 1 : octaves); ++i) {
        const std::vector<double> coarse = blur(1 << i);
        double sum = 0, squares = 0;
        for (size_t k = 0; k < fine.size(); ++k) {
            sum += fine[k] - coarse[k];
            squares += (fine[k] - coarse[k]) * (fine[k] - coarse[k]);
        }
        const double n = double(fine.size()), mean = slip == Slip::mean ? 0 : sum / n;
        const double deviation = std::sqrt(std::max(0.0, squares / n - mean * mean));
        const double size = slip == Slip::size ? 1 : 1 << i, by = slip == Slip::even ? 1 : deviation;
        for (size_t k = 0; k < fine.size() && deviation > 1e-9; ++k) heights[k] += size * (fine[k] - coarse[k]) / by;
        fine = coarse;
    }
    const double factor = slope / (slip == Slip::per_octave ? 1 : octaves) * (slip == Slip::half ? 1 : 0.5);
    const double east = slip == Slip::downhill ? factor : -factor, north = slip == Slip::south ? -east : east;
    std::vector<glm::dvec3> normals;
    const auto at = [&](int x, int y) { return heights[size_t(row(y) * width + column(x))]; };
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            normals.push_back(glm::normalize(
                glm::dvec3(east * (at(x + 1, y) - at(x - 1, y)), north * (at(x, y - 1) - at(x, y + 1)), 1)));
    return normals;
}

const std::pair<Slip, const char*> slips[] = {
    {Slip::clamped_x, "x goes around the planet: left of the first texel lies the last of its row"},
    {Slip::wrapped_y, "columns end at the poles: y stays within the map"},
    {Slip::even, "each octave is divided by the standard deviation of its texels"},
    {Slip::mean, "a standard deviation is taken from the mean, which is not 0 here"},
    {Slip::size, "octave i is multiplied by the size of its features, 2^i texels"},
    {Slip::octave_0, "that is octave 0 alone"},
    {Slip::south, "north is up, row y - 1"},
    {Slip::downhill, "a slope that rises to the east leans to the west"},
    {Slip::per_octave, "f is the slope over the number of octaves"},
    {Slip::half, "a central difference is over two texels: half of it per texel"}};

struct Map {
    const char* name;
    int width, height, octaves;
    double slope;
    std::function<double(int x, int y)> brightness;
};

}  // namespace

CHECK_EXERCISE("17.overlay_normals",
               "octaves are differences of blurred maps; each is divided by its deviation and multiplied by 2^i") {
    Random random(8);
    const auto noise = [&](int, int) { return random.uniform(0, 1); };
    // Radii of up to 128 go around the last one more than once.
    const Map maps[] = {
        {"an even map", 64, 32, 4, 1, [](int, int) { return 0.5; }},
        {"noise", 64, 32, 1, 1, noise},
        {"noise", 64, 32, 4, 1, noise},
        {"a bright band across the date line", 64, 32, 4, 1, [](int x, int) { return x < 8 || x > 40; }},
        {"a map that darkens to the north", 64, 32, 4, 1, [](int, int y) { return y / 32.0; }},
        {"noise", 64, 32, 2, 0.3, noise},
        {"noise", 40, 24, 4, 1, noise},
        {"a wave around the planet, and noise", 100, 40, 8, 1,
         [&](int x, int) { return 0.5 + 0.3 * std::sin(x * 0.0628318530717959) + random.uniform(-0.1, 0.1); }}};
    for (const Map& one : maps) {
        std::vector<float> map;
        for (int y = 0; y < one.height; ++y)
            for (int x = 0; x < one.width; ++x) map.push_back(float(one.brightness(x, y)));
        const std::string what =
            fmt::format("overlay_normals({} x {}, {}, {} octaves)", one.width, one.height, one.name, one.octaves);
        check.call(what, [&]() -> std::string {
            const auto got = overlay_normals(one.width, one.height, map, one.octaves, float(one.slope));
            if (got.size() != map.size())
                return fmt::format("{} gave {} normals, expected {}", what, got.size(), map.size());
            const auto right = slow_normals(one.width, one.height, map, one.octaves, one.slope);
            const auto away = [&](size_t i, const std::vector<glm::dvec3>& from) {
                return glm::length(glm::dvec3(got[i]) - from[i]);
            };
            // The normal that is farthest off tells most.
            size_t worst = 0;
            for (size_t i = 1; i < got.size(); ++i)
                if (!(away(i, right) <= away(worst, right))) worst = i;
            if (away(worst, right) < 2e-3) return "";
            const glm::dvec3 g(got[worst]);
            std::string text = fmt::format("{}: at ({}, {}) it {}", what, int(worst) % one.width,
                                           int(worst) / one.width, gave_text({&g.x, 3}, {&right[worst].x, 3}));
            for (const auto& [slip, words] : slips) {
                const auto wrong = slow_normals(one.width, one.height, map, one.octaves, one.slope, slip);
                bool fits = true;
                for (size_t i = 0; i < got.size() && fits; ++i) fits = away(i, wrong) < 2e-3;
                if (fits) return text + ": " + words;
            }
            return text;
        });
        if (check.failed) return;
    }
}
