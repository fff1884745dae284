#include "15_terrain_water/ground_textures.h"

#include <algorithm>
#include <cmath>

#include "common/image/image.h"
#include "common/image/luminance.h"
#include "common/scene/scene_file.h"

namespace lightwalk {
namespace {

constexpr int side = 512;

/// 0 to 1, the same for the same cell of a tile of `period` cells. Cells lie at most one beside the tile: divisions would take
/// a fifth of the time of a picture's start.
float random_at(int x, int y, int period, uint32_t seed) {
    const auto wrapped = [&](int i) {
        return static_cast<uint32_t>(i < 0 ? i + period : i >= period ? i - period : i);
    };
    uint32_t h = wrapped(x) * 0x9E3779B1u ^ wrapped(y) * 0x85EBCA77u ^ seed * 0xC2B2AE3Du;
    h = (h ^ (h >> 15)) * 0x2C1B3C6Du, h = (h ^ (h >> 12)) * 0x297A2D39u;
    return static_cast<float>((h ^ (h >> 15)) >> 8) / 16777216.0f;
}

float smooth_noise(glm::vec2 p, int period, uint32_t seed) {
    const glm::ivec2 cell(glm::floor(p));
    const glm::vec2 f = glm::fract(p), t = f * f * (3.0f - 2.0f * f);
    const auto at = [&](int x, int y) { return random_at(cell.x + x, cell.y + y, period, seed); };
    return glm::mix(glm::mix(at(0, 0), at(1, 0), t.x), glm::mix(at(0, 1), at(1, 1), t.x), t.y);
}

float sum_of_octaves(glm::vec2 uv, int period, int octaves, float gain, uint32_t seed) {
    float sum = 0, weight = 0, amplitude = 1;
    for (int k = 0; k < octaves; ++k, period *= 2, amplitude *= gain) {
        sum += amplitude * smooth_noise(uv * static_cast<float>(period), period, seed + uint32_t(k));
        weight += amplitude;
    }
    return sum / weight;
}

/// Crowns of trees: the height of the tallest dome over a place, and which tree it is (0 to 1).
glm::vec2 crowns(glm::vec2 uv, int period, uint32_t seed) {
    const glm::vec2 p = uv * static_cast<float>(period);
    const glm::ivec2 cell(glm::floor(p));
    glm::vec2 best(0.0f);
    for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x) {
            const int cx = cell.x + x, cy = cell.y + y;
            const glm::vec2 middle(float(cx) + 0.15f + 0.7f * random_at(cx, cy, period, seed),
                                   float(cy) + 0.15f + 0.7f * random_at(cx, cy, period, seed + 1));
            const float tree = random_at(cx, cy, period, seed + 2), radius = 0.55f + 0.3f * tree;
            const float d = glm::length(p - middle) / radius;
            const float height = (0.6f + 0.4f * tree) * std::sqrt(std::max(1.0f - d * d, 0.0f));
            if (height > best.x) best = {height, random_at(cx, cy, period, seed + 3)};
        }
    return best;
}

/// Albedo and height.
glm::vec4 grass(glm::vec2 uv) {
    const float patches = sum_of_octaves(uv, 4, 4, 0.6f, 11), blades = sum_of_octaves(uv, 64, 3, 0.8f, 23);
    const float dry = glm::smoothstep(0.45f, 0.7f, patches);
    const glm::vec3 color = glm::mix(glm::vec3(0.060f, 0.088f, 0.022f), glm::vec3(0.135f, 0.118f, 0.048f), dry);
    return {color * (0.55f + 0.9f * blades), 0.35f * patches + 0.5f * blades};
}
glm::vec4 forest(glm::vec2 uv) {
    const glm::vec2 crown = crowns(uv, 12, 31), young = crowns(uv, 27, 57);
    const bool tall = crown.x > 0.55f * young.x;
    const float height = std::max(crown.x, 0.55f * young.x), tree = tall ? crown.y : young.y;
    const float leaves = sum_of_octaves(uv, 64, 3, 0.8f, 71);
    const glm::vec3 color = glm::mix(glm::vec3(0.022f, 0.042f, 0.014f), glm::vec3(0.068f, 0.075f, 0.020f), tree);
    return {color * (0.35f + 0.75f * height) * (0.6f + 0.8f * leaves), 0.85f * height + 0.15f * leaves};
}
glm::vec4 snow(glm::vec2 uv) {
    const float drifts = sum_of_octaves(uv, 4, 5, 0.45f, 91);
    return {glm::vec3(0.82f, 0.85f, 0.9f) * (0.92f + 0.1f * drifts), drifts};
}

/// The bark lies on its side: its fibres become layers of rock.
class Rock {
  public:
    glm::vec4 at(int x, int y, glm::vec2 uv) const {
        const glm::vec3 photo = photo_.at(y * photo_.width / side, x * photo_.height / side);
        const float light = luminance(photo);
        const float stains = sum_of_octaves(uv, 3, 4, 0.6f, 7);
        const glm::vec3 color = glm::mix(glm::vec3(light), photo, 0.45f) * (0.55f + 0.6f * stains);
        return {color, glm::clamp(light * 2.2f, 0.0f, 1.0f)};
    }

  private:
    ImageRgb photo_ = read_image_linear(find_asset("textures/bark_albedo.jpg"));
};

}  // namespace

void make_ground_textures(Gpu& gpu, Image& materials, Image& bumps) {
    std::vector<glm::u8vec4> texels, slopes;
    const Rock rock;
    for (int layer = 0; layer < 4; ++layer) {
        std::vector<glm::vec4> surface(size_t(side) * side);
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x) {
                const glm::vec2 uv = (glm::vec2(x, y) + 0.5f) / static_cast<float>(side);
                surface[size_t(y) * side + size_t(x)] = layer == 0   ? grass(uv)
                                                        : layer == 1 ? forest(uv)
                                                        : layer == 2 ? rock.at(x, y, uv)
                                                                     : snow(uv);
            }
        const auto height = [&](int x, int y) {
            return surface[size_t((y + side) % side) * side + size_t((x + side) % side)].a;
        };
        const auto code = [](float v) { return static_cast<uint8_t>(std::lround(255 * glm::clamp(v, 0.0f, 1.0f))); };
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x) {
                const glm::vec4 s = surface[size_t(y) * side + size_t(x)];
                texels.emplace_back(code(std::sqrt(s.r)), code(std::sqrt(s.g)), code(std::sqrt(s.b)), code(s.a));
                const float scale = side / 2.0f / 32.0f / 2.0f;
                slopes.emplace_back(code(0.5f + scale * (height(x + 1, y) - height(x - 1, y))),
                                    code(0.5f + scale * (height(x, y + 1) - height(x, y - 1))), 0, 255);
            }
    }
    const auto upload = [&](Image& image, const char* name, const std::vector<glm::u8vec4>& from) {
        image = Image(gpu.device, {.name = name,
                                   .format = VK_FORMAT_R8G8B8A8_UNORM,
                                   .size = glm::uvec2(side),
                                   .mips = full_mip_count(glm::uvec2(side)),
                                   .layers = 4});
        gpu.upload(image, std::as_bytes(std::span(from)));
    };
    upload(materials, "ground materials", texels), upload(bumps, "ground bumps", slopes);
}

}  // namespace lightwalk
