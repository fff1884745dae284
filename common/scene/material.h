// Surface materials: MTL (Wavefront, "Material Library File", 1995) with the common PBR extension.
#pragma once
#include <cstddef>
#include <filesystem>
#include <glm/glm.hpp>
#include <memory>
#include <string>
#include <vector>

#include "common/gpu/sampler.h"

namespace lightwalk {

/// Texture coordinate transform: uv' = turn · uv + offset, with v = 0 at the bottom row.
struct MapPlace {
    glm::mat2 turn{1.0f};
    glm::vec2 offset{0.0f};
    uint32_t set = 0;  ///< coordinate set: 0 Vertex::uv, 1 Mesh::second_uvs
    bool is_plain() const { return *this == MapPlace(); }
    bool operator==(const MapPlace&) const = default;
};

/// Converts between v upwards and glTF's v downwards; an involution.
MapPlace flipped(const MapPlace& place);

/// Channel code: alpha if the image has it, else luminance.
inline constexpr char alpha_if_any = 'd';

struct TextureMap {
    std::filesystem::path file;  ///< path, or name within a model file; empty: none
    int32_t image = -1;          ///< index into Model::images of an embedded image
    std::shared_ptr<const std::vector<std::byte>> bytes{};
    float bump_multiplier = 1.0f;     ///< -bm
    glm::vec3 offset{0.0f};           ///< -o
    glm::vec3 scale{1.0f};            ///< -s
    glm::vec2 base_gain{0.0f, 1.0f};  ///< -mm
    bool clamp = false;               ///< -clamp
    char channel = 0;                 ///< -imfchan: r g b m l z, alpha_if_any; 0: all channels
    bool is_color = false;            ///< sRGB-encoded, although in a data slot
    MapPlace place;                   ///< glTF transform, including -o and -s
    Sampler sampler;
    explicit operator bool() const { return !file.empty(); }
    bool operator==(const TextureMap&) const = default;
};

enum class Sides { unknown, front, both };

/// Material without textures. Colours are linear, in [0, 1] where physical; textures multiply them.
struct MaterialNumbers {
    std::string name;
    glm::vec3 ambient{0.0f}, diffuse{0.8f}, specular{0.0f}, emissive{0.0f};  ///< Ka Kd Ks Ke
    float shininess = 32.0f;                                                 ///< Ns, Blinn–Phong exponent, 0 to 1000
    float opacity = 1.0f;                                                    ///< d, or 1 − Tr
    /// Tf: share of the light from behind that passes, by channel, of the 1 − opacity that opacity leaves; negative:
    /// unspecified, all of it.
    glm::vec3 transmission{-1.0f};
    float refraction = 1.5f;                   ///< Ni
    float roughness = 0.5f, metalness = 0.0f;  ///< Pr Pm
    bool blend = false;                        ///< alpha blending; false: alpha cuts holes
    float alpha_cutoff = -1;                   ///< alpha below it is a hole; 0: none; negative: unspecified
    Sides sides = Sides::unknown;
    bool metallic_roughness = false;  ///< specified by base colour, roughness and metalness
    bool microfacets = false;         ///< specified by roughness: GGX
    bool has_exponent = false;        ///< specified by Ks and Ns, too, which the course's scenes use
    bool unlit = false;
    float normal_scale = 1, occlusion_strength = 1;
    int illumination = 2;  ///< illum, 0 to 10
};

struct Material : MaterialNumbers {
    TextureMap diffuse_map, specular_map, ambient_map, emissive_map, shininess_map, opacity_map;
    TextureMap bump_map, normal_map, displacement_map, roughness_map, metalness_map;
    std::vector<std::string> left_out;
    TextureMap occlusion_map, metallic_roughness_map;  ///< red; roughness in green, metalness in blue
};

inline constexpr TextureMap Material::*all_maps[] = {
    &Material::diffuse_map,           &Material::specular_map,  &Material::ambient_map,   &Material::emissive_map,
    &Material::shininess_map,         &Material::opacity_map,   &Material::bump_map,      &Material::normal_map,
    &Material::displacement_map,      &Material::roughness_map, &Material::metalness_map, &Material::occlusion_map,
    &Material::metallic_roughness_map};

}  // namespace lightwalk
