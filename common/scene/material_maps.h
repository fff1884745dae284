// The textures of a material, by slot.
#pragma once
#include <array>
#include <optional>
#include <set>

#include "common/scene/image_pool.h"
#include "common/scene/material.h"
#include "common/scene/scene_file.h"

namespace lightwalk {

/// In the order of MaterialData::maps' bits.
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
    std::string name, binding;  ///< "diffuse", and its binding in shaders: "diffuse_map"
    TextureKind kind;
    int channels;                      ///< that a texture must have at least
    const TextureMap Material::*from;  ///< the model's own map; null if only a scene file can name it
    bool is_normal;                    ///< without a texture it is flat; others are white
};

inline constexpr size_t map_slot_count = 12;
const std::array<MapSlotInfo, map_slot_count>& map_slots();

/// How a model's material fills that slot; nothing if it does not.
std::optional<TextureUse> texture_use(const Material& material, MapSlot slot);

/// A texture for each slot; null if the material has none.
struct MapImages : std::array<std::shared_ptr<Image>, map_slot_count> {
    using array::operator[];
    std::shared_ptr<Image>& operator[](MapSlot slot) { return (*this)[static_cast<size_t>(slot)]; }
    const std::shared_ptr<Image>& operator[](MapSlot slot) const { return (*this)[static_cast<size_t>(slot)]; }
};

/// Textures, with their places and samplers.
struct MaterialMaps : MapImages {
    /// MaterialData::maps: DIFFUSE_MAP and so on.
    uint32_t bits() const;

    std::array<MapPlace, map_slot_count> places{};
    std::array<Sampler, map_slot_count> samplers{};
    /// Whether a texture lies otherwise than by Vertex::uv; whether one lies by the second coordinates.
    bool are_placed() const;
    bool use_second_uvs() const;
    bool operator==(const MaterialMaps&) const = default;
};

/// The textures named by a model's material, overridden by the scene file's. An unreadable one of the material is
/// omitted with a warning, once per text in `warned`. Throws InputError for one of the scene file: an unknown slot,
/// or as ImagePool::load.
MaterialMaps load_maps(ImagePool& images, const Material& own, const MaterialOverride& with,
                       std::set<std::string>& warned);

}  // namespace lightwalk
