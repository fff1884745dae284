#include "common/scene/material_maps.h"

#include "common/base/error.h"
#include "common/base/text.h"
#include "common/structs.h"

namespace lightwalk {
namespace {

constexpr TextureKind color = TextureKind::color, data = TextureKind::data;
static_assert(DIFFUSE_MAP == 1u << int(MapSlot::diffuse) &&
              METALLIC_ROUGHNESS_MAP == 1u << int(MapSlot::metallic_roughness));

size_t find_slot(const std::string& name) {
    std::string known;
    for (size_t i = 0; i < map_slot_count; ++i) {
        if (map_slots()[i].name == name) return i;
        known += (known.empty() ? "" : ", ") + map_slots()[i].name;
    }
    throw InputError("unknown texture slot '{}'; there are: {}", name, known);
}

std::shared_ptr<Image> load_map(ImagePool& images, const TextureUse& use, const MapSlotInfo& slot) {
    try {
        return images.load(use);
    } catch (const InputError& e) { throw InputError("{} map: {}", slot.name, e.what()); }
}

}  // namespace

// Slots without an MTL statement can only be set by scene files.
const std::array<MapSlotInfo, map_slot_count>& map_slots() {
    static const std::array<MapSlotInfo, map_slot_count> slots{{
        {"diffuse", "diffuse_map", color, 1, &Material::diffuse_map, false},
        {"specular", "specular_map", data, 1, &Material::specular_map, false},
        {"emissive", "emissive_map", color, 1, &Material::emissive_map, false},
        {"opacity", "opacity_map", data, 1, &Material::opacity_map, false},
        {"normal", "normal_map", data, 3, &Material::normal_map, true},
        {"height", "height_map", data, 1, &Material::displacement_map, false},
        {"orm", "orm_map", data, 3, nullptr, false},
        {"occlusion", "occlusion_map", data, 1, &Material::occlusion_map, false},
        {"gloss", "gloss_map", data, 1, &Material::shininess_map, false},
        {"detail_normal", "detail_normal_map", data, 3, nullptr, true},
        {"displacement", "displacement_map", data, 1, nullptr, false},  // MTL's disp sets the height map
        {"metallic_roughness", "metallic_roughness_map", data, 1, &Material::metallic_roughness_map, false},
    }};
    return slots;
}

std::optional<TextureUse> texture_use(const Material& material, MapSlot which) {
    const MapSlotInfo& slot = map_slots()[static_cast<size_t>(which)];
    TextureUse use{.kind = slot.kind, .channels = slot.channels};
    if (slot.from) use.map = material.*slot.from;
    if (use.map.is_color) use.kind = TextureKind::color;
    if (which == MapSlot::normal && !use.map && material.bump_map) {
        use.map = material.bump_map;
        use.as = TextureUse::As::normals;
        use.channels = 1;
    }
    if (which == MapSlot::metallic_roughness && !use.map && (material.roughness_map || material.metalness_map)) {
        use.map = material.roughness_map;
        use.metalness = material.metalness_map;
        use.as = TextureUse::As::roughness_metalness;
    }
    return use.map || use.metalness ? std::optional(use) : std::nullopt;
}

bool MaterialMaps::are_placed() const {
    for (size_t i = 0; i < size(); ++i)
        if ((*this)[i] && !places[i].is_plain()) return true;
    return false;
}

bool MaterialMaps::use_second_uvs() const {
    for (size_t i = 0; i < size(); ++i)
        if ((*this)[i] && places[i].set == 1) return true;
    return false;
}

uint32_t MaterialMaps::bits() const {
    uint32_t bits = 0;
    for (size_t i = 0; i < size(); ++i) bits |= (*this)[i] ? 1u << i : 0u;
    return bits;
}

MaterialMaps load_maps(ImagePool& images, const Material& own, const MaterialOverride& with,
                       std::set<std::string>& warned) {
    MaterialMaps maps;
    for (size_t i = 0; i < map_slot_count; ++i) {
        const auto use = texture_use(own, static_cast<MapSlot>(i));
        if (!use) continue;
        maps.places[i] = use->map ? use->map.place : use->metalness.place;
        maps.samplers[i] = use->map ? use->map.sampler : use->metalness.sampler;
        try {
            maps[i] = load_map(images, *use, map_slots()[i]);
        } catch (const InputError& e) {
            if (warned.insert(own.name + "\n" + e.what()).second)
                warn("material '{}': {}; drawn without it", own.name, e.what());
        }
    }
    for (const auto& [name, texture] : with.maps) {
        const size_t slot = find_slot(name);
        const MapSlotInfo& info = map_slots()[slot];
        maps[slot] = load_map(
            images, {.map = {.file = find_asset(texture)}, .kind = info.kind, .channels = info.channels}, info);
        maps.places[slot] = {};
        maps.samplers[slot] = {};
    }
    // Overridden by values or textures of the scene file.
    if (maps[MapSlot::orm] || with.roughness || with.metalness || with.specular || with.shininess)
        maps[MapSlot::metallic_roughness] = nullptr;
    return maps;
}

}  // namespace lightwalk
