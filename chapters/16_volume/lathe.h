// Rings and halls by code: a profile that turns about the y axis, covered with panels.
#pragma once
#include <filesystem>
#include <vector>

#include "common/scene/mesh.h"

namespace lightwalk {

// [lathe]
/// Contents of a .lathe file: JSON with these keys.
struct Lathe {
    std::vector<glm::vec2> profile;  ///< distance from the axis and height, metres; its right-hand side is outside
    std::vector<int> rows;           ///< of panels along each part of the profile
    bool closed = true;              ///< the last point is joined to the first
    int columns = 160;               ///< cells around the axis, 8 to 1024
    int longest = 5;                 ///< most cells that a panel spans, 1 to 32
    float relief_m = 0.01f;          ///< how far panels stand out or lie in, at most
    float bevel_m = 0.006f;          ///< width of their slanted edges
    float glow = 0.05f;              ///< share of panels with glowing squares, 0 to 1
    int seed = 1;
    glm::vec3 albedo{0.3f}, second{0.2f};             ///< linear; of two kinds of panels
    glm::vec3 specular{0.3f}, second_specular{0.5f};  ///< linear
    glm::vec3 glow_color{1.0f, 0.6f, 0.3f};           ///< linear, 0 to 1
    float glow_strength = 4;                          ///< radiance of glow_color 1
};
// [/lathe]

/// A panel, or the groove around it.
struct LathePanel {
    bool glows = false, is_second = false;
    float shade = 1;               ///< multiplies its albedo
    float gloss = 0.5f;            ///< as the gloss map, 0 to 1
    glm::vec2 lower{0}, upper{0};  ///< its place in the texture, 0 to 1
};

/// A quadrangle with a rectangle as its texture region. Corners: (u, v) lower lower, lower upper, upper upper, upper
/// lower.
struct LatheQuad {
    glm::vec3 position[4], normal[4];
    glm::vec2 lower, upper;
    uint32_t panel = 0;
    bool is_top = false;  ///< not one of the slanted edges
};

struct LatheParts {
    std::vector<LatheQuad> quads;
    std::vector<LathePanel> panels;
};

bool is_lathe_file(const std::filesystem::path& file);

/// Throws InputError: file: key: message.
Lathe read_lathe(const std::filesystem::path& file);

/// Every panel of it. The texture goes once around in u, and along the profile in v.
LatheParts turn_lathe(const Lathe& lathe);

/// Two triangles for each quadrangle, with one material.
Model lathe_model(const Lathe& lathe, const LatheParts& parts);

}  // namespace lightwalk
