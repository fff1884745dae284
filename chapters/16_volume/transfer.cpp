#include "16_volume/transfer.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "16_volume/exercises.h"
#include "16_volume/volume_data.h"

namespace lightwalk {
namespace {

struct Point {
    float density;
    glm::vec3 color;
    float opacity;  ///< of REFERENCE_M metres
};

// Colours above 1 shine. Between two points colour and opacity change evenly.
const std::map<std::string, std::vector<Point>> functions{
    {"nebula",
     {{0.0f, {0.10f, 0.16f, 0.9f}, 0.0f},
      {0.09f, {0.12f, 0.2f, 1.0f}, 0.0f},
      {0.19f, {0.22f, 0.25f, 1.1f}, 0.008f},
      {0.34f, {0.9f, 0.22f, 0.75f}, 0.022f},
      {0.55f, {1.5f, 0.45f, 0.25f}, 0.055f},
      {0.78f, {2.2f, 1.3f, 0.55f}, 0.10f},
      {1.0f, {3.0f, 2.7f, 2.2f}, 0.16f}}},
    {"skin",
     {{0.0f, {0.8f, 0.5f, 0.4f}, 0.0f},
      {0.12f, {0.8f, 0.5f, 0.4f}, 0.0f},
      {0.2f, {0.85f, 0.55f, 0.42f}, 0.55f},
      {0.45f, {0.9f, 0.6f, 0.48f}, 0.8f},
      {1.0f, {0.95f, 0.75f, 0.65f}, 0.9f}}},
    {"inside",
     {{0.0f, {0.8f, 0.4f, 0.3f}, 0.0f},
      {0.10f, {0.8f, 0.4f, 0.3f}, 0.0f},
      {0.16f, {0.9f, 0.42f, 0.3f}, 0.012f},
      {0.30f, {0.9f, 0.35f, 0.25f}, 0.004f},
      {0.44f, {0.95f, 0.8f, 0.6f}, 0.03f},
      {0.56f, {1.0f, 0.92f, 0.78f}, 0.35f},
      {1.0f, {1.0f, 0.97f, 0.9f}, 0.6f}}},
    {"shell",
     {{0.0f, {1.0f, 0.8f, 0.5f}, 0.0f},
      {0.49f, {1.0f, 0.8f, 0.5f}, 0.0f},
      {0.5f, {1.0f, 0.8f, 0.5f}, 0.5f},
      {0.51f, {1.0f, 0.8f, 0.5f}, 0.0f},
      {1.0f, {1.0f, 0.8f, 0.5f}, 0.0f}}},
    {"even", {{0.0f, {1.0f, 1.0f, 1.0f}, 0.0f}, {1.0f, {1.0f, 1.0f, 1.0f}, 0.2f}}}};

}  // namespace

const std::vector<std::string>& transfer_names() {
    static const std::vector<std::string> names{"nebula", "skin", "inside", "shell", "even"};
    return names;
}

std::vector<glm::vec4> transfer_function(const std::string& name, float density) {
    const std::vector<Point>& points = functions.at(name);
    std::vector<glm::vec4> texels;
    for (int i = 0; i < TRANSFER_TEXELS; ++i) {
        const float at = static_cast<float>(i) / static_cast<float>(TRANSFER_TEXELS - 1);
        size_t next = 1;
        while (next + 1 < points.size() && points[next].density < at) ++next;
        const Point &a = points[next - 1], &b = points[next];
        const float share = std::clamp((at - a.density) / (b.density - a.density), 0.0f, 1.0f);
        const float opacity = glm::mix(a.opacity, b.opacity, share);
        texels.emplace_back(glm::mix(a.color, b.color, share), 1.0f - std::pow(1.0f - opacity, density));
    }
    return texels;
}

std::vector<glm::vec4> preintegrated_table(const std::vector<glm::vec4>& transfer, int texels, float ratio) {
    std::vector<glm::vec4> table;
    table.reserve(static_cast<size_t>(texels) * static_cast<size_t>(texels));
    const auto density = [&](int i) { return static_cast<float>(i) / static_cast<float>(texels - 1); };
    for (int back = 0; back < texels; ++back)
        for (int front = 0; front < texels; ++front)
            table.push_back(preintegrate(transfer, density(front), density(back), ratio));
    return table;
}

float thinnest_layer(const std::vector<glm::vec4>& transfer) {
    float thinnest = 1;
    for (size_t peak = 1; peak + 1 < transfer.size(); ++peak) {
        const float top = transfer[peak].a;
        if (top <= 0 || transfer[peak - 1].a > top || transfer[peak + 1].a > top) continue;
        size_t first = peak, last = peak;
        while (first > 0 && transfer[first - 1].a > top / 2) --first;
        while (last + 1 < transfer.size() && transfer[last + 1].a > top / 2) ++last;
        if (first == 0 || last + 1 == transfer.size()) continue;  // it goes on to the end of the range
        thinnest = std::min(thinnest, static_cast<float>(last - first + 1) / static_cast<float>(transfer.size()));
    }
    return thinnest;
}

}  // namespace lightwalk
