// A map of Pluto made here.
#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "17_planets/maps.h"

namespace lightwalk {
namespace {

float at_corner(glm::ivec3 cell, uint32_t layer) {
    uint32_t h = static_cast<uint32_t>(cell.x) * 73856093u ^ static_cast<uint32_t>(cell.y) * 19349663u ^
                 static_cast<uint32_t>(cell.z) * 83492791u ^ layer * 2654435761u;
    h = (h ^ (h >> 16)) * 0x7feb352du;
    h = (h ^ (h >> 15)) * 0x846ca68bu;
    h ^= h >> 16;
    return static_cast<float>(h >> 8) * (2.0f / 16777215.0f) - 1.0f;
}

float noise(glm::vec3 at, uint32_t layer) {
    const glm::ivec3 cell(glm::floor(at));
    const glm::vec3 f = at - glm::vec3(cell), s = f * f * (3.0f - 2.0f * f);
    float sum = 0;
    for (int i = 0; i < 8; ++i) {
        const glm::ivec3 corner(i & 1, i >> 1 & 1, i >> 2);
        const glm::vec3 w = glm::mix(1.0f - s, s, glm::vec3(corner));
        sum += w.x * w.y * w.z * at_corner(cell + corner, layer);
    }
    return sum;
}

float octaves(glm::vec3 at, uint32_t layer, int count) {
    float sum = 0, height = 0.5f;
    for (int i = 0; i < count; ++i, height *= 0.55f, at *= 2.07f)
        sum += height * noise(at, layer + static_cast<uint32_t>(i));
    return sum;
}

float step(float from, float to, float x) {
    const float s = std::clamp((x - from) / (to - from), 0.0f, 1.0f);
    return s * s * (3 - 2 * s);
}

// How far inside an ellipse on the map, in degrees: 1 in its middle, 0 at its edge and beyond.
float within(float longitude, float latitude, glm::vec2 middle, glm::vec2 half) {
    float east = std::remainder(longitude - middle.x, 360.0f) * std::cos(glm::radians(latitude));
    const glm::vec2 d = glm::vec2(east, latitude - middle.y) / half;
    return std::max(0.0f, 1 - glm::length(d));
}

}  // namespace

std::vector<uint8_t> pluto_map(int width, int height) {
    std::vector<uint8_t> texels;
    texels.reserve(static_cast<size_t>(width) * static_cast<size_t>(height) * 4);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            // East of the prime meridian, which faces Charon.
            const float longitude = 360.0f * (static_cast<float>(x) + 0.5f) / static_cast<float>(width) - 180.0f;
            const float latitude = 90.0f - 180.0f * (static_cast<float>(y) + 0.5f) / static_cast<float>(height);
            const float l = glm::radians(longitude), b = glm::radians(latitude);
            const glm::vec3 at(std::cos(b) * std::sin(l), std::sin(b), std::cos(b) * std::cos(l));
            const float coarse = octaves(at * 4.0f, 1, 6), fine = octaves(at * 16.0f, 21, 5);
            const float lon = longitude + 7 * coarse, lat = latitude + 6 * octaves(at * 3.0f + 9.0f, 41, 5);
            glm::vec3 color(0.60f, 0.53f, 0.46f);  // as seen, sRGB
            color += 0.16f * coarse + 0.16f * fine;
            color =
                glm::mix(color, glm::vec3(0.74f, 0.66f, 0.54f), 0.7f * step(35, 65, lat));  // Lowell Regio, methane ice
            const float belt =
                step(13, 4, std::fabs(lat + 7.0f + 4 * std::sin(2 * l))) * step(-0.5f, 0.1f, coarse + 0.25f);
            color = glm::mix(color, glm::vec3(0.30f, 0.20f, 0.15f) + 0.10f * fine,
                             0.88f * belt);  // Belton Regio and its kin
            const float west = step(0.0f, 0.22f, within(lon, lat, {174, 24}, {15, 29}) + 0.05f * coarse);
            const float east = step(0.0f, 0.35f, within(lon, lat, {203, 14}, {20, 22}) + 0.06f * coarse);
            const float tip = step(0.0f, 0.4f, within(lon, lat, {183, -6}, {13, 22}));
            color = glm::mix(color, glm::vec3(0.84f, 0.80f, 0.74f) + 0.08f * fine, 0.9f * std::max(east, tip));
            // The plain of nitrogen ice: smooth, in cells some 30 km wide.
            const float cells = step(0.02f, 0.10f, std::fabs(noise(at * 38.0f, 77)));
            color = glm::mix(color, glm::vec3(0.93f, 0.89f, 0.82f) - 0.025f * (1 - cells), west);
            for (int c = 0; c < 3; ++c)
                texels.push_back(static_cast<uint8_t>(std::clamp(255.0f * color[c] + 0.5f, 0.0f, 255.0f)));
            // Gloss: the plain's fresh nitrogen ice, and less of the methane in the north.
            texels.push_back(static_cast<uint8_t>(255 * std::max(west, 0.35f * step(35, 65, lat))));
        }
    return texels;
}

}  // namespace lightwalk
