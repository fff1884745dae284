// Texture slots of materials.
#pragma once
#include <array>
#include <optional>
#include <set>

#include "common/scene/image_pool.h"
#include "common/scene/material.h"
#include "common/scene/scene_file.h"

namespace lightwalk {

/// Order of the bits in MaterialData::maps.
enum class MapSlot {
    diffuse,
    specular,
    emissive,
    opacity,
    normal,
    height,
    orm,
    occlusion,
    gloss,
    detail_normal,
    displacement,
    metallic_roughness
};

struct MapSlotInfo {
    std::string name, binding;  ///< for instance "diffuse", and "diffuse_map" in shaders
    TextureKind kind;
    int channels;
    const TextureMap Material::*from;  ///< source in the model's material; null: scene file only
    bool is_normal;                    ///< default texel: flat normal instead of white
};

inline constexpr size_t map_slot_count = 12;
const std::array<MapSlotInfo, map_slot_count>& map_slots();

std::optional<TextureUse> texture_use(const Material& material, MapSlot slot);

struct MapImages : std::array<std::shared_ptr<Image>, map_slot_count> {
    using array::operator[];
    std::shared_ptr<Image>& operator[](MapSlot slot) { return (*this)[static_cast<size_t>(slot)]; }
    const std::shared_ptr<Image>& operator[](MapSlot slot) const { return (*this)[static_cast<size_t>(slot)]; }
};

struct MaterialMaps : MapImages {
    uint32_t bits() const;

    std::array<MapPlace, map_slot_count> places{};
    std::array<Sampler, map_slot_count> samplers{};
    /// True if some texture has a transform or uses the second coordinates; use_second_uvs(): only the latter.
    bool are_placed() const;
    bool use_second_uvs() const;
    bool operator==(const MaterialMaps&) const = default;
};

/// Loads the textures of a model's material, overridden by the scene file's. Unreadable ones of the material are
/// omitted with a warning, once per text in `warned`. Throws InputError for those of the scene file: unknown slot, or
/// as ImagePool::load().
MaterialMaps load_maps(ImagePool& images, const Material& own, const MaterialOverride& with,
                       std::set<std::string>& warned);

}  // namespace lightwalk
