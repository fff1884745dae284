// A surface as MTL describes it (Wavefront, "Material Library File", 1995), with the usual PBR extension.
#pragma once
#include <cstddef>
#include <filesystem>
#include <glm/glm.hpp>
#include <memory>
#include <string>
#include <vector>

#include "common/gpu/sampler.h"

namespace lightwalk {

/// Where a map lies on a surface: uv' = turn · uv + offset, v = 0 being the image's bottom row.
struct MapPlace {
    glm::mat2 turn{1.0f};
    glm::vec2 offset{0.0f};
    uint32_t set = 0;  ///< texture coordinates: 0 Vertex::uv, 1 Mesh::second_uvs
    bool is_plain() const { return *this == MapPlace(); }
    bool operator==(const MapPlace&) const = default;
};

/// The same place with v reversed, as in glTF; its own inverse.
MapPlace flipped(const MapPlace& place);

/// The alpha channel of an image that has one, else the luminance.
inline constexpr char alpha_if_any = 'd';

/// A texture reference with the options of MTL and glTF.
/// Large (2 functions, 12 members): one member for each key of a scene file.
struct TextureMap {
    std::filesystem::path file;  ///< whole path; of an image inside a model file its name there; empty: no map
    int32_t image = -1;          ///< of Model::images, where the image lies inside the model file
    std::shared_ptr<const std::vector<std::byte>> bytes{};  ///< that image, encoded
    float bump_multiplier = 1.0f;                           ///< -bm
    glm::vec3 offset{0.0f};                                 ///< -o
    glm::vec3 scale{1.0f};                                  ///< -s
    glm::vec2 base_gain{0.0f, 1.0f};                        ///< -mm
    bool clamp = false;                                     ///< -clamp
    char channel = 0;                                       ///< -imfchan: r g b m l z; alpha_if_any; 0: all
    bool is_color = false;                                  ///< sRGB, in a slot of data
    MapPlace place;                                         ///< glTF's; -o and -s are in it, too
    Sampler sampler;
    explicit operator bool() const { return !file.empty(); }
    bool operator==(const TextureMap&) const = default;
};

enum class Sides { unknown, front, both };

/// A material without its maps: each item of a scene holds one. Colours are linear, in [0, 1] where physical; maps
/// multiply them.
struct MaterialNumbers {
    std::string name;
    glm::vec3 ambient{0.0f}, diffuse{0.8f}, specular{0.0f}, emissive{0.0f};  ///< Ka Kd Ks Ke
    float shininess = 32.0f;                                                 ///< Ns, Blinn–Phong exponent, 0 to 1000
    float opacity = 1.0f;                                                    ///< d, or 1 − Tr
    float refraction = 1.5f;                                                 ///< Ni
    float roughness = 0.5f, metalness = 0.0f;                                ///< Pr Pm
    bool blend = false;       ///< alpha and opacity blend with the background instead of cutting holes
    float alpha_cutoff = -1;  ///< alpha below it is a hole; 0: no holes; below 0: the file does not say
    Sides sides = Sides::unknown;
    bool metallic_roughness = false;  ///< stated by base colour, roughness and metalness
    bool microfacets = false;         ///< stated by roughness: reflects by GGX
    bool has_exponent = false;        ///< stated by Ks and Ns, too: scenes of the course keep to these
    bool unlit = false;               ///< shows its diffuse colour, unlit
    float normal_scale = 1, occlusion_strength = 1;
    int illumination = 2;  ///< illum, 0 to 10
};

struct Material : MaterialNumbers {
    TextureMap diffuse_map, specular_map, ambient_map, emissive_map, shininess_map, opacity_map;
    TextureMap bump_map, normal_map, displacement_map, roughness_map, metalness_map;
    std::vector<std::string> left_out;                 ///< properties of the file that are not used
    TextureMap occlusion_map, metallic_roughness_map;  ///< red; green and blue times roughness and metalness
};

inline constexpr TextureMap Material::*all_maps[] = {
    &Material::diffuse_map,           &Material::specular_map,  &Material::ambient_map,   &Material::emissive_map,
    &Material::shininess_map,         &Material::opacity_map,   &Material::bump_map,      &Material::normal_map,
    &Material::displacement_map,      &Material::roughness_map, &Material::metalness_map, &Material::occlusion_map,
    &Material::metallic_roughness_map};

}  // namespace lightwalk
