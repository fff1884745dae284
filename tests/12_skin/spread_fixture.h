// Shared by the tests of the spread of light: synthetic maps, and their results.
#pragma once
#include <cmath>
#include <functional>
#include <glm/gtc/packing.hpp>

#include "../common/module_fixture.h"
#include "12_skin/skin.h"
#include "12_skin/truth.h"

namespace lightwalk {

/// A map as numbers: each texel's position and entering light. per_mm: texels per mm along u and v.
struct FlatMap {
    glm::uvec2 size{64, 64};
    glm::vec2 per_mm{4, 4};
    std::function<glm::vec3(int x, int y)> light = [](int, int) { return glm::vec3(1); };
    std::function<int(int x, int y)> chart = [](int, int) { return 1; };
    std::function<glm::dvec3(double u_mm, double v_mm)> place_mm = [](double u, double v) {
        return glm::dvec3(u, v, 0);
    };
};

struct OnSpread : OnModules {
    Spread spread;

    static std::vector<truth::SkinTexel> texels_of(const FlatMap& map) {
        std::vector<truth::SkinTexel> texels;
        for (int y = 0; y < int(map.size.y); ++y)
            for (int x = 0; x < int(map.size.x); ++x) {
                const glm::vec3 light = glm::unpackHalf4x16(glm::packHalf4x16(glm::vec4(map.light(x, y), 0)));
                texels.push_back({map.place_mm(x / double(map.per_mm.x), y / double(map.per_mm.y)), glm::dvec3(light),
                                  1.0 / double(map.per_mm.x * map.per_mm.y), map.chart(x, y)});
            }
        return texels;
    }

    /// gaussians as Spread::record takes them.
    ImageRgb leaving(const FlatMap& map, int gaussians) {
        const Image light(gpu.device, {.name = "light", .size = map.size}),
            stretch(gpu.device, {.name = "stretch", .size = map.size}),
            position(gpu.device, {.name = "position", .format = four_floats, .size = map.size});
        std::vector<uint64_t> lights, stretches;
        std::vector<glm::vec4> positions;
        for (const truth::SkinTexel& t : texels_of(map)) {
            lights.push_back(glm::packHalf4x16(glm::vec4(t.light, float(t.chart))));
            stretches.push_back(glm::packHalf4x16(glm::vec4(map.per_mm, t.area_mm2, 0)));
            positions.emplace_back(glm::vec3(0.001 * t.place_mm), float(t.chart));
        }
        frame.begin({4, 4}, 0);
        frame.upload("light", light, std::as_bytes(std::span(lights)));
        frame.upload("stretch", stretch, std::as_bytes(std::span(stretches)));
        frame.upload("position", position, std::as_bytes(std::span(positions)));
        spread.record(frame, {light, stretch, position}, gaussians);
        frame.end();
        return read_linear(gpu, spread.result());
    }
};

inline bool is_finite(const ImageRgb& picture) {
    for (const glm::vec3& pixel : picture.pixels)
        if (!std::isfinite(pixel.r) || !std::isfinite(pixel.g) || !std::isfinite(pixel.b)) return false;
    return true;
}

}  // namespace lightwalk
