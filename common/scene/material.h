// A surface as MTL describes it (Wavefront, "Material Library File", 1995), with the usual PBR extension.
#pragma once
#include <filesystem>
#include <glm/glm.hpp>
#include <string>

namespace lightwalk {

/// A texture reference with MTL's options.
struct TextureMap {
    std::filesystem::path file;       ///< resolved against the MTL's folder; empty: no map
    float bump_multiplier = 1.0f;     ///< -bm
    glm::vec3 offset{0.0f};           ///< -o
    glm::vec3 scale{1.0f};            ///< -s
    glm::vec2 base_gain{0.0f, 1.0f};  ///< -mm
    bool clamp = false;               ///< -clamp
    char channel = 0;                 ///< -imfchan: r g b m l z, 0 where the file does not say
    explicit operator bool() const { return !file.empty(); }
    bool operator==(const TextureMap&) const = default;
};

/// Colours are linear, in [0, 1] where physical; maps multiply them.
struct Material {
    std::string name;
    glm::vec3 ambient{0.0f}, diffuse{0.8f}, specular{0.0f}, emissive{0.0f};  ///< Ka Kd Ks Ke
    float shininess = 32.0f;                                                 ///< Ns, Blinn–Phong exponent, 0 to 1000
    float opacity = 1.0f;                                                    ///< d, or 1 − Tr
    float refraction = 1.5f;                                                 ///< Ni
    float roughness = 0.5f, metalness = 0.0f;                                ///< Pr Pm
    bool blend = false;    ///< alpha and opacity let through what lies behind, rather than cut holes
    int illumination = 2;  ///< illum, 0 to 10
    TextureMap diffuse_map, specular_map, ambient_map, emissive_map, shininess_map, opacity_map;
    TextureMap bump_map, normal_map, displacement_map, roughness_map, metalness_map;
};

}  // namespace lightwalk
