#include "16_volume/finish.h"

#include <fmt/core.h>

#include <cmath>
#include <cstring>
#include <map>

#include "common/base/files.h"
#include "common/base/kept.h"
#include "common/base/patience.h"
#include "common/base/shared_lock.h"
#include "common/gpu/glsl.h"
#include "common/image/image.h"
#include "common/image/mip_levels.h"

namespace lightwalk {
namespace {

/// Calls visit(texel, quad, share of the path through it) for each texel with its centre in a quadrangle.
template <class Visit>
void for_each_texel(const std::vector<LatheQuad>& quads, glm::uvec2 size, const Visit& visit) {
    const glm::vec2 texels(size);
    for (const LatheQuad& quad : quads) {
        const glm::ivec2 first(glm::ceil(quad.lower * texels - 0.5f)), last(glm::ceil(quad.upper * texels - 0.5f));
        for (int y = std::max(first.y, 0); y < std::min(last.y, int(size.y)); ++y)
            for (int x = std::max(first.x, 0); x < std::min(last.x, int(size.x)); ++x) {
                const glm::vec2 at = (glm::vec2(x, y) + 0.5f) / texels;
                // v = 0 is the bottom row of an image.
                visit(size_t(size.y - 1 - uint32_t(y)) * size.x + size_t(x), quad,
                      (at - quad.lower) / (quad.upper - quad.lower), at);
            }
    }
}

std::byte code(float value) { return std::byte(std::lround(255 * std::clamp(value, 0.0f, 1.0f))); }
std::byte srgb_code(float value) { return code(linear_to_srgb(value)); }

using TexelBytes = std::vector<std::byte>;

template <class Code>
void put(TexelBytes& texels, size_t texel, glm::vec3 color, const Code& to_code) {
    for (int c = 0; c < 3; ++c) texels[4 * texel + size_t(c)] = to_code(color[c]);
    texels[4 * texel + 3] = std::byte(255);
}

std::shared_ptr<Image> image_of(Gpu& gpu, const char* name, VkFormat format, glm::uvec2 size,
                                const TexelBytes& texels) {
    auto image = std::make_shared<Image>(
        gpu.device, Image::Desc{.name = name, .format = format, .size = size, .mips = full_mip_count(size)});
    gpu.upload(*image, mip_levels(format, size, texels));
    return image;
}

/// In a glowing panel: a row of squares.
bool is_glowing(const LathePanel& panel, glm::vec2 at, float cell) {
    const glm::vec2 share = (at - panel.lower) / (panel.upper - panel.lower);
    const float within = std::fmod((at.x - panel.lower.x) / cell, 1.0f);
    return panel.glows && share.y > 0.34f && share.y < 0.66f && within > 0.25f && within < 0.75f;
}

}  // namespace

Finish::Finish(Module& owner, std::string name) : Module(owner, std::move(name), "finish") {}

void Finish::prepare(Gpu& gpu, Scene& scene) {
    std::map<std::filesystem::path, Maps> made;
    for (DrawItem& item : scene.items) {
        const std::filesystem::path& file = scene.file.objects[item.object].model;
        if (!is_lathe_file(file)) continue;
        if (!made.contains(file)) made[file] = make(gpu, find_asset(file));
        const Maps& maps = made[file];
        item.maps[MapSlot::diffuse] = maps.diffuse;
        item.maps[MapSlot::specular] = maps.specular;
        item.maps[MapSlot::emissive] = maps.emissive;
        item.maps[MapSlot::gloss] = maps.gloss;
        item.maps[MapSlot::occlusion] = maps.occlusion;
    }
}

Finish::Maps Finish::make(Gpu& gpu, const std::filesystem::path& file) {
    const Lathe lathe = read_lathe(file);
    const LatheParts parts = unlocked([&] { return turn_lathe(lathe); });
    const auto texels_wide = static_cast<uint32_t>(width.value);
    const glm::uvec2 size(texels_wide, texels_wide / 8);
    const size_t bytes = size_t{4} * size.x * size.y;
    TexelBytes diffuse(bytes), specular(bytes), emissive(bytes), gloss(bytes);
    const auto paint = [&](size_t texel, const LatheQuad& quad, glm::vec2, glm::vec2 at) {
        const LathePanel& panel = parts.panels[quad.panel];
        const bool glows = quad.is_top && is_glowing(panel, at, 1.0f / static_cast<float>(lathe.columns));
        // Edges are worn: brighter, and smoother. Glowing parts receive no light.
        const float shade = glows ? 0.0f : quad.is_top ? panel.shade : 1.25f;
        put(diffuse, texel, shade * (panel.is_second ? lathe.second : lathe.albedo), srgb_code);
        put(specular, texel, glows ? glm::vec3(0) : panel.is_second ? lathe.second_specular : lathe.specular, code);
        put(emissive, texel, glows ? lathe.glow_color : glm::vec3(0), srgb_code);
        put(gloss, texel, glm::vec3(quad.is_top ? panel.gloss : 0.75f), code);
    };
    unlocked([&] { for_each_texel(parts.quads, size, paint); });
    const std::vector<std::byte> seen = occlusion(gpu, file, parts, size / 2u);
    TexelBytes occluded(4 * seen.size());
    for (size_t i = 0; i < seen.size(); ++i)
        put(occluded, i, glm::vec3(float(std::to_integer<int>(seen[i])) / 255), code);
    return {.diffuse = image_of(gpu, "albedo", VK_FORMAT_R16G16B16A16_SFLOAT, size, linear_halves(diffuse)),
            .specular = image_of(gpu, "specular", VK_FORMAT_R8G8B8A8_UNORM, size, specular),
            .emissive = image_of(gpu, "exemption", VK_FORMAT_R16G16B16A16_SFLOAT, size, linear_halves(emissive)),
            .gloss = image_of(gpu, "gloss", VK_FORMAT_R8G8B8A8_UNORM, size, gloss),
            .occlusion = image_of(gpu, "baked occlusion", VK_FORMAT_R8G8B8A8_UNORM, size / 2u, occluded)};
}

// From the cache, or baked and put there.
std::vector<std::byte> Finish::occlusion(Gpu& gpu, const std::filesystem::path& file, const LatheParts& parts,
                                         glm::uvec2 size) {
    const std::string key =
        fmt::format("occlusion {} {} {} {} ", size.x, size.y, bake_rays.value, bake_m.value) + read_file(file) +
        flatten_bare("16_volume/bake.comp", {}, "16_volume/bake.comp").text;  // an answer of a reader's own, too
    return kept_or_made<std::byte>(key, ".occlusion", size_t{size.x} * size.y, [&] {
        ++baked;
        return bake(gpu, file, parts, size);
    });
}

// A ray begins at each texel's place on the mesh. Some rows at a time: no dispatch takes long, and a person sees how far
// it is.
std::vector<std::byte> Finish::bake(Gpu& gpu, const std::filesystem::path& file, const LatheParts& parts,
                                    glm::uvec2 size) {
    SceneFile alone;
    alone.objects.push_back({.name = "alone", .parent = "", .model = file});
    Scene scene;
    scene.load(gpu, alone, [&](const std::filesystem::path&) { return lathe_model({}, parts); });
    rays_.build(gpu, scene);
    std::vector<glm::vec4> places(size_t{size.x} * size.y), normals(places.size());
    const auto place = [&](size_t texel, const LatheQuad& quad, glm::vec2 share, glm::vec2) {
        const auto mixed = [&](const glm::vec3(&of)[4]) {
            return glm::mix(glm::mix(of[0], of[1], share.y), glm::mix(of[3], of[2], share.y), share.x);
        };
        places[texel] = glm::vec4(mixed(quad.position), 1);
        normals[texel] = glm::vec4(glm::normalize(mixed(quad.normal)), 0);
    };
    unlocked([&] { for_each_texel(parts.quads, size, place); });
    const Buffer place_buffer = gpu.upload("places", places), normal_buffer = gpu.upload("normals", normals);
    const Buffer result(gpu.device, {.name = "occlusion", .bytes = 4 * places.size()});
    Patience patience("baking the occlusion of " + file.filename().string(), "rows");
    const uint32_t rows = std::max(1u, (1u << 21) / (size.x * static_cast<uint32_t>(bake_rays)));
    for (uint32_t row = 0; row < size.y; row += rows) {
        patience.show(static_cast<int>(row), static_cast<int>(size.y));
        Frame frame(gpu);
        frame.begin({1, 1}, 0);
        const glm::uvec4 part(row * size.x, std::min(rows, size.y - row) * size.x, bake_rays.value, 0);
        frame.compute("bake occlusion", {.writes = {result}, .with = {rays_}}, [&](Compute& pass) {
            pass.use(bake_).set("places", place_buffer).set("normals", normal_buffer).set("result", result);
            pass.set("part", part).set("reach_m", bake_m.value).dispatch_threads(glm::uvec3(part.y, 1, 1));
        });
        frame.end();
    }
    const std::vector<std::byte> raw = gpu.read_back(result);
    std::vector<std::byte> seen(places.size());
    for (size_t i = 0; i < seen.size(); ++i) {
        float value = 0;
        std::memcpy(&value, raw.data() + 4 * i, 4);
        seen[i] = code(value);
    }
    return seen;
}

}  // namespace lightwalk
