#include "17_planets/maps.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/packing.hpp>

#include "17_planets/exercises.h"
#include "common/base/files.h"
#include "common/base/kept.h"
#include "common/base/shared_lock.h"
#include "common/image/image.h"
#include "common/image/luminance.h"
#include "common/image/mip_levels.h"
#include "common/scene/scene_file.h"

namespace lightwalk {

namespace {

constexpr int slope_rows = 512, ring_texels = 4096;

// Slopes from a map of any size, at 1024 x 512, and in alpha its brightness from the darkest to the brightest, as height.
struct Slopes {
    glm::uvec2 size;
    std::vector<glm::u8vec4> texels;
};

Slopes slopes_of(const ImageRgb& map, const BodyTraits& body) {
    const int height = std::min(slope_rows, map.height), width = 2 * height;
    const int across = std::max(map.width / width, 1), down = std::max(map.height / height, 1);
    std::vector<float> brightness;
    brightness.reserve(static_cast<size_t>(width * height));
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            float sum = 0;
            for (int j = 0; j < down; ++j)
                for (int i = 0; i < across; ++i) {
                    const glm::vec3 c =
                        map.at(std::min(x * across + i, map.width - 1), std::min(y * down + j, map.height - 1));
                    sum += luminance(c);
                }
            brightness.push_back(std::sqrt(std::max(sum, 0.0f) / static_cast<float>(across * down)));
        }
    const std::vector<glm::vec3> normals = overlay_normals(width, height, brightness, body.octaves, body.slope);
    const auto [least, most] = std::minmax_element(brightness.begin(), brightness.end());
    const float scale = 1 / std::max(*most - *least, 1e-6f);
    std::vector<glm::u8vec4> texels;
    texels.reserve(normals.size());
    for (size_t i = 0; i < normals.size(); ++i) {
        const glm::vec4 texel(0.5f + 0.5f * normals[i], scale * (brightness[i] - *least));
        texels.emplace_back(255.0f * texel + 0.5f);
    }
    return {{width, height}, std::move(texels)};
}

std::shared_ptr<Image> slope_image(Gpu& gpu, const Slopes& slopes) {
    auto image = std::make_shared<Image>(gpu.device, Image::Desc{.name = "slopes",
                                                                 .format = VK_FORMAT_R8G8B8A8_UNORM,
                                                                 .size = slopes.size,
                                                                 .mips = full_mip_count(slopes.size)});
    gpu.upload(*image, mip_levels(image->desc.format, slopes.size, std::as_bytes(std::span(slopes.texels))));
    return image;
}

std::shared_ptr<Image> ring_image(Gpu& gpu, BodyId body) {
    const std::vector<glm::vec4> strip = unlocked([&] { return ring_strip(body, ring_texels); });
    const glm::uvec2 size(ring_texels, 1);
    std::vector<uint64_t> texels;
    for (int layer = 0; layer < 4; ++layer)
        for (const glm::vec4& texel : layer ? ring_table(strip, layer - 1, 0.35) : strip)
            texels.push_back(glm::packHalf4x16(texel));
    auto image = std::make_shared<Image>(gpu.device, Image::Desc{.name = "rings",
                                                                 .format = VK_FORMAT_R16G16B16A16_SFLOAT,
                                                                 .size = size,
                                                                 .mips = full_mip_count(size),
                                                                 .layers = 4});
    gpu.upload(*image, mip_levels(image->desc.format, size, std::as_bytes(std::span(texels)), 4));
    return image;
}

// Seconds of noise: from the cache, under a key that changes with the noise.
std::vector<uint8_t> kept_pluto_map(int width, int height) {
    const std::vector<uint8_t> small = pluto_map(32, 16);
    const std::string_view fingerprint(reinterpret_cast<const char*>(small.data()), small.size());
    return kept_or_made<uint8_t>(fmt::format("pluto {} {} {}", width, height, hash_bytes(fingerprint)), ".map",
                                 size_t(width) * size_t(height) * 4, [&] { return pluto_map(width, height); });
}

std::shared_ptr<Image> made_map(Gpu& gpu) {
    const int height = slope_rows * 2;
    const std::vector<uint8_t> texels = unlocked([&] { return kept_pluto_map(2 * height, height); });
    const glm::uvec2 size(2 * height, height);
    constexpr VkFormat format = VK_FORMAT_R16G16B16A16_SFLOAT;
    auto image = std::make_shared<Image>(
        gpu.device, Image::Desc{.name = "pluto", .format = format, .size = size, .mips = full_mip_count(size)});
    gpu.upload(*image, mip_levels(format, size, linear_halves(std::as_bytes(std::span(texels)))));
    return image;
}

}  // namespace

BodyMaps load_maps(Gpu& gpu, ImagePool& pool, BodyId body, bool frames) {
    const BodyTraits& of = traits(body);
    const auto load = [&](const char* file, TextureKind kind) { return pool.load(find_asset(file), kind); };
    BodyMaps maps;
    if (of.map) maps.color = load(of.map, TextureKind::color);
    if (body == BodyId::pluto) maps.color = made_map(gpu);
    if (body == BodyId::jupiter && frames) {
        maps.frames = {maps.color};
        for (int day = 1; day <= sequence_days; ++day)
            maps.frames.push_back(
                pool.load(find_asset(fmt::format("planets_2k/jupiter_{}.jpg", day)), TextureKind::color));
    }
    if (of.octaves > 0 && of.map)
        maps.normals = slope_image(gpu, unlocked([&] { return slopes_of(read_image_linear(find_asset(of.map)), of); }));
    if (body == BodyId::pluto) {
        const auto of_pluto = [&] {
            const int height = slope_rows;
            const std::vector<uint8_t> texels = kept_pluto_map(2 * height, height);
            ImageRgb map(2 * height, height);
            for (size_t i = 0; i < map.pixels.size(); ++i) map.pixels[i] = glm::vec3(srgb_to_linear(texels[4 * i]));
            return slopes_of(map, of);
        };
        maps.normals = slope_image(gpu, unlocked(of_pluto));
    }
    if (rings_of(body).outer > 0) maps.rings = ring_image(gpu, body);
    if (body == BodyId::earth) {
        maps.night = load("planets/earth_night.jpg", TextureKind::color);
        maps.clouds = load("planets/earth_clouds.jpg", TextureKind::data);
        maps.water = load("planets/earth_specular.jpg", TextureKind::data);
    }
    return maps;
}

FrameInterval frame_interval(double days, float period_days) {
    const int step = period_days < 1.5f ? 1 : period_days < 3 ? 2 : 4, count = sequence_days / step + 1;
    const double loop_days = step * count;
    const auto in_loop = static_cast<float>(days - loop_days * std::floor(days / loop_days));
    const int first = static_cast<int>(in_loop) / step;
    return {.first = static_cast<size_t>(first % count * step),
            .second = static_cast<size_t>((first + 1) % count * step),
            .days = in_loop,
            .period_days = static_cast<float>(step)};
}

namespace scattering {

static double mean_of_exp(double x) { return x < 1e-8 ? 1 - 0.5 * x : -std::expm1(-x) / x; }
static double henyey_greenstein(double cosine, double g) {
    const double b = 1 + g * g - 2 * g * cosine;
    return (1 - g * g) / (b * std::sqrt(b));
}

double back(double depth, double mu0, double mu) { return 0.25 * depth / mu * mean_of_exp(depth * (1 / mu + 1 / mu0)); }
double through(double depth, double mu0, double mu) {
    const double a = depth / mu0, b = depth / mu;
    return 0.25 * b * std::exp(-std::min(a, b)) * mean_of_exp(std::fabs(a - b));
}
double more(double depth, double albedo, bool lit) {
    return albedo * albedo * (lit ? 1.2 * -std::expm1(-2 * depth) : 1.46 * std::expm1(0.92 * std::min(depth, 3.0)));
}
double particle_phase(double cos_phase) {
    return 0.98 * henyey_greenstein(cos_phase, 0.45) + 0.02 * henyey_greenstein(-cos_phase, 0.7);
}

}  // namespace scattering

std::vector<glm::vec4> ring_strip(BodyId body, int texels) {
    const Rings rings = rings_of(body);
    const double width = static_cast<double>(rings.outer - rings.inner) / texels;
    const std::span<const RingPart> parts = ring_parts(body);
    const float albedo = parts.empty() ? 0.0f : static_cast<float>(parts.front().albedo);
    std::vector<glm::vec4> strip(static_cast<size_t>(texels), glm::vec4(glm::vec3(albedo), 0.0f));
    for (int i = 0; i < texels; ++i) {
        const double from = static_cast<double>(rings.inner) + i * width, to = from + width;
        double depth = 0;
        for (const RingPart& part : parts)  // narrower than a texel: its share of it
            depth += part.depth * std::max(0.0, std::min(to, part.outer_m) - std::max(from, part.inner_m)) / width;
        strip[static_cast<size_t>(i)].a = static_cast<float>(depth);
    }
    if (body != BodyId::saturn) return strip;
    // Detail finer than the published parts: ringlets from a photograph's strip, with alpha varying around each
    // part's mean.
    const Image8 photo = read_image8(find_asset("textures/saturn_ring.png"));
    const auto at = [&](double r_m) {
        const double u = (r_m / traits(body).radius_m - 1.22) / (2.28 - 1.22) * photo.width;
        return photo.at(std::clamp(static_cast<int>(u), 0, photo.width - 1), 0);
    };
    for (const RingPart& part : ring_parts(body)) {
        double sum = 0, n = 0;
        for (int i = 0; i < texels; ++i) {
            const double r = static_cast<double>(rings.inner) + (i + 0.5) * width;
            if (r < part.inner_m || r > part.outer_m) continue;
            sum += -std::log(1 - std::min(at(r).a / 255.0, 0.97));
            n += 1;
        }
        for (int i = 0; i < texels; ++i) {
            const double r = static_cast<double>(rings.inner) + (i + 0.5) * width;
            if (r < part.inner_m || r > part.outer_m || sum <= 0) continue;
            const glm::u8vec4 seen = at(r);
            glm::vec4& texel = strip[static_cast<size_t>(i)];
            texel.a *=
                static_cast<float>(std::clamp(-std::log(1 - std::min(seen.a / 255.0, 0.97)) / (sum / n), 0.3, 2.5));
            const glm::vec3 color(srgb_to_linear(seen.r), srgb_to_linear(seen.g), srgb_to_linear(seen.b));
            const float bright = std::max({color.r, color.g, color.b, 1e-3f}),
                        ringlet = std::clamp(0.55f + 0.9f * bright, 0.6f, 1.15f);
            const glm::vec3 hue = glm::mix(color / bright, glm::vec3(1.0f, 0.89f, 0.74f), 0.8f);
            texel = glm::vec4(glm::min(static_cast<float>(part.albedo) * ringlet * hue, 1.0f), texel.a);
        }
    }
    return strip;
}

std::vector<glm::vec4> ring_table(const std::vector<glm::vec4>& strip, int table, double elevation_rad) {
    // Against the sun the tables are exact; with the sun behind the camera they are the best fit to phase angles from
    // 0 to 90 degrees (least squares over the cosine): the peak at 0 is narrow, the mix of two tables is not.
    const double forward = scattering::particle_phase(-1);
    double products = 0, squares = 0;
    for (int i = 0; i < 200; ++i) {
        const double cosine = (i + 0.5) / 200, share = 0.5 + 0.5 * cosine;
        products += share * (scattering::particle_phase(cosine) - forward * (1 - share));
        squares += share * share;
    }
    const double mu = std::sin(elevation_rad);
    const double phase = table == 0 ? products / squares : table == 1 ? forward : scattering::particle_phase(0.6);
    std::vector<glm::vec4> out;
    for (const glm::vec4& texel : strip) {
        const double depth = static_cast<double>(texel.a);
        const bool lit = table != 2;
        const double sent = phase + scattering::more(depth, static_cast<double>(texel.r), lit);
        const double light = sent * (lit ? scattering::back(depth, mu, mu) : scattering::through(depth, mu, mu));
        out.emplace_back(static_cast<float>(light) * glm::vec3(texel), texel.a);
    }
    return out;
}

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
