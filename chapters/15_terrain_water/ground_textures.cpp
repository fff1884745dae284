#include <algorithm>
#include <cmath>

#include "15_terrain_water/land.h"
#include "common/base/shared_lock.h"
#include "common/image/image.h"
#include "common/image/luminance.h"
#include "common/image/mip_levels.h"
#include "common/scene/scene_file.h"

namespace lightwalk {
namespace {

constexpr int tile_side = 512;

/// 0 to 1, the same for the same cell of a tile of `period` cells. Cells lie at most one beside the tile.
float random_at(int x, int y, int period, uint32_t seed) {
    const auto wrapped = [&](int i) {
        return static_cast<uint32_t>(i < 0 ? i + period : i >= period ? i - period : i);
    };
    uint32_t h = wrapped(x) * 0x9E3779B1u ^ wrapped(y) * 0x85EBCA77u ^ seed * 0xC2B2AE3Du;
    h = (h ^ (h >> 15)) * 0x2C1B3C6Du;
    h = (h ^ (h >> 12)) * 0x297A2D39u;
    return static_cast<float>((h ^ (h >> 15)) >> 8) / 16777216.0f;
}

/// Octaves of smooth noise along a row of a tile; values shared by the whole row are computed once.
class Octaves {
  public:
    Octaves(int period, int octaves, float gain, uint32_t seed) {
        float amplitude = 1;
        for (int k = 0; k < octaves; ++k, period *= 2, amplitude *= gain)
            octaves_.push_back({period, seed + uint32_t(k), amplitude, 0, {}, {}});
    }

    void to_row(float v) {
        for (Octave& octave : octaves_) {
            const float at = v * static_cast<float>(octave.period), part = glm::fract(at);
            const int cell = static_cast<int>(std::floor(at));
            octave.across = part * part * (3.0f - 2.0f * part);
            octave.here.clear();
            octave.next.clear();
            for (int x = 0; x <= octave.period; ++x) {
                octave.here.push_back(random_at(x, cell, octave.period, octave.seed));
                octave.next.push_back(random_at(x, cell + 1, octave.period, octave.seed));
            }
        }
    }

    float at(float u) const {
        float sum = 0, weight = 0;
        for (const Octave& octave : octaves_) {
            const float at = u * static_cast<float>(octave.period), whole = std::floor(at), part = at - whole;
            const float t = part * part * (3.0f - 2.0f * part);
            const auto cell = static_cast<size_t>(whole);
            sum += octave.amplitude * glm::mix(glm::mix(octave.here[cell], octave.here[cell + 1], t),
                                               glm::mix(octave.next[cell], octave.next[cell + 1], t), octave.across);
            weight += octave.amplitude;
        }
        return sum / weight;
    }

  private:
    struct Octave {
        int period;
        uint32_t seed;
        float amplitude, across;
        std::vector<float> here, next;  ///< at the corners of the row's cells, above and below it
    };
    std::vector<Octave> octaves_;
};

/// Crowns of trees, one in each of `period` by `period` cells of a tile and in those around it.
class Crowns {
  public:
    Crowns(int period, uint32_t seed) : period_(period) {
        for (int y = -1; y <= period; ++y)
            for (int x = -1; x <= period; ++x) {
                const float tree = random_at(x, y, period, seed + 2);
                trees_.push_back({{float(x) + 0.15f + 0.7f * random_at(x, y, period, seed),
                                   float(y) + 0.15f + 0.7f * random_at(x, y, period, seed + 1)},
                                  0.55f + 0.3f * tree,
                                  0.6f + 0.4f * tree,
                                  random_at(x, y, period, seed + 3)});
            }
    }

    /// The height of the tallest dome over a place, and which tree it is (0 to 1).
    glm::vec2 at(glm::vec2 uv) const {
        const glm::vec2 p = uv * static_cast<float>(period_);
        const glm::ivec2 cell(glm::floor(p));
        glm::vec2 best(0.0f);
        for (int y = 0; y < 3; ++y)
            for (int x = 0; x < 3; ++x) {
                const Tree& tree = trees_[size_t(cell.y + y) * size_t(period_ + 2) + size_t(cell.x + x)];
                const float d = glm::length(p - tree.middle) / tree.radius;
                const float height = tree.height * std::sqrt(std::max(1.0f - d * d, 0.0f));
                if (height > best.x) best = {height, tree.which};
            }
        return best;
    }

  private:
    struct Tree {
        glm::vec2 middle;
        float radius, height, which;
    };
    int period_;
    std::vector<Tree> trees_;
};

/// Ground cover: albedo and height at points of one row after the other.
struct Grass {
    Octaves patches{4, 4, 0.6f, 11}, blades{64, 3, 0.8f, 23};
    void to_row(float v) {
        patches.to_row(v);
        blades.to_row(v);
    }
    glm::vec4 at(glm::vec2 uv) const {
        const float patch = patches.at(uv.x), blade = blades.at(uv.x);
        const float dry = glm::smoothstep(0.45f, 0.7f, patch);
        const glm::vec3 color = glm::mix(glm::vec3(0.060f, 0.088f, 0.022f), glm::vec3(0.135f, 0.118f, 0.048f), dry);
        return {color * (0.55f + 0.9f * blade), 0.35f * patch + 0.5f * blade};
    }
};

struct Forest {
    Crowns old{12, 31}, young{27, 57};
    Octaves leaves{64, 3, 0.8f, 71};
    void to_row(float v) { leaves.to_row(v); }
    glm::vec4 at(glm::vec2 uv) const {
        const glm::vec2 crown = old.at(uv), small = young.at(uv);
        const bool tall = crown.x > 0.55f * small.x;
        const float height = std::max(crown.x, 0.55f * small.x), tree = tall ? crown.y : small.y;
        const float leaf = leaves.at(uv.x);
        const glm::vec3 color = glm::mix(glm::vec3(0.022f, 0.042f, 0.014f), glm::vec3(0.068f, 0.075f, 0.020f), tree);
        return {color * (0.35f + 0.75f * height) * (0.6f + 0.8f * leaf), 0.85f * height + 0.15f * leaf};
    }
};

/// The bark lies on its side: its fibres become layers of rock.
struct Rock {
    Octaves stains{3, 4, 0.6f, 7};
    ImageRgb bark = read_image_linear(find_asset("textures/bark_albedo.jpg"));
    void to_row(float v) { stains.to_row(v); }
    glm::vec4 at(glm::vec2 uv) const {
        const glm::ivec2 texel(uv * static_cast<float>(tile_side));
        const glm::vec3 photo = bark.at(texel.y * bark.width / tile_side, texel.x * bark.height / tile_side);
        const float light = luminance(photo);
        const glm::vec3 color = glm::mix(glm::vec3(light), photo, 0.45f) * (0.55f + 0.6f * stains.at(uv.x));
        return {color, glm::clamp(light * 2.2f, 0.0f, 1.0f)};
    }
};

struct Snow {
    Octaves drifts{4, 5, 0.45f, 91};
    void to_row(float v) { drifts.to_row(v); }
    glm::vec4 at(glm::vec2 uv) const {
        const float drift = drifts.at(uv.x);
        return {glm::vec3(0.82f, 0.85f, 0.9f) * (0.92f + 0.1f * drift), drift};
    }
};

/// A texel is made of a material's height and of those beside it.
template <class Material>
void add_layer(Material material, std::vector<glm::u8vec4>& texels, std::vector<glm::u8vec4>& slopes) {
    std::vector<glm::vec4> surface;
    surface.reserve(size_t(tile_side) * tile_side);
    for (int y = 0; y < tile_side; ++y) {
        material.to_row((static_cast<float>(y) + 0.5f) / static_cast<float>(tile_side));
        for (int x = 0; x < tile_side; ++x)
            surface.push_back(material.at((glm::vec2(x, y) + 0.5f) / static_cast<float>(tile_side)));
    }
    const auto height = [&](int x, int y) {
        return surface[size_t((y + tile_side) % tile_side) * tile_side + size_t((x + tile_side) % tile_side)].a;
    };
    const auto code = [](float v) { return static_cast<uint8_t>(std::lround(255 * glm::clamp(v, 0.0f, 1.0f))); };
    for (int y = 0; y < tile_side; ++y)
        for (int x = 0; x < tile_side; ++x) {
            const glm::vec4 s = surface[size_t(y) * tile_side + size_t(x)];
            texels.emplace_back(code(std::sqrt(s.r)), code(std::sqrt(s.g)), code(std::sqrt(s.b)), code(s.a));
            const float scale = tile_side / 2.0f / 32.0f / 2.0f;
            slopes.emplace_back(code(0.5f + scale * (height(x + 1, y) - height(x - 1, y))),
                                code(0.5f + scale * (height(x, y + 1) - height(x, y - 1))), 0, 255);
        }
}

}  // namespace

void make_ground_textures(Gpu& gpu, Image& materials, Image& bumps) {
    std::vector<glm::u8vec4> texels, slopes;
    unlocked([&] {
        add_layer(Grass(), texels, slopes);
        add_layer(Forest(), texels, slopes);
        add_layer(Rock(), texels, slopes);
        add_layer(Snow(), texels, slopes);
    });
    const auto upload = [&](Image& image, const char* name, const std::vector<glm::u8vec4>& from) {
        image = Image(gpu.device, {.name = name,
                                   .format = VK_FORMAT_R8G8B8A8_UNORM,
                                   .size = glm::uvec2(tile_side),
                                   .mips = full_mip_count(glm::uvec2(tile_side)),
                                   .layers = 4});
        gpu.upload(image, mip_levels(image.desc.format, glm::uvec2(tile_side), std::as_bytes(std::span(from)), 4));
    };
    upload(materials, "ground materials", texels);
    upload(bumps, "ground bumps", slopes);
}

}  // namespace lightwalk
