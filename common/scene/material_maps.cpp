#include "common/scene/material_maps.h"

#include "common/base/error.h"
#include "common/base/text.h"
#include "common/structs.h"

namespace lightwalk {
namespace {

constexpr TextureKind color = TextureKind::color, data = TextureKind::data;
static_assert(DIFFUSE_MAP == 1u << int(MapSlot::diffuse) && DISPLACEMENT_MAP == 1u << int(MapSlot::displacement));

size_t find_slot(const std::string& name) {
    std::string known;
    for (size_t i = 0; i < map_slot_count; ++i) {
        if (map_slots()[i].name == name) return i;
        known += (known.empty() ? "" : ", ") + map_slots()[i].name;
    }
    throw InputError("unknown texture slot '{}'; there are: {}", name, known);
}

std::shared_ptr<Image> load_map(ImagePool& images, const std::filesystem::path& file, const MapSlotInfo& slot) {
    try {
        return images.load(file, slot.kind, slot.channels);
    } catch (const InputError& e) { throw InputError("{} map: {}", slot.name, e.what()); }
}

}  // namespace

// What MTL has no statement for, only a scene file can name.
const std::array<MapSlotInfo, map_slot_count>& map_slots() {
    static const std::array<MapSlotInfo, map_slot_count> slots{{
        {"diffuse", "diffuse_map", color, 1, &Material::diffuse_map, false},
        {"specular", "specular_map", data, 1, &Material::specular_map, false},
        {"emissive", "emissive_map", color, 1, &Material::emissive_map, false},
        {"opacity", "opacity_map", data, 1, &Material::opacity_map, false},
        {"normal", "normal_map", data, 3, &Material::normal_map, true},
        {"height", "height_map", data, 1, &Material::displacement_map, false},
        {"orm", "orm_map", data, 3, nullptr, false},
        {"occlusion", "occlusion_map", data, 1, nullptr, false},
        {"gloss", "gloss_map", data, 1, &Material::shininess_map, false},
        {"detail_normal", "detail_normal_map", data, 3, nullptr, true},
        {"displacement", "displacement_map", data, 1, nullptr, false},  // MTL's disp is the height map
    }};
    return slots;
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
        const MapSlotInfo& slot = map_slots()[i];
        if (!slot.from || !(own.*slot.from)) continue;
        try {
            maps[i] = load_map(images, (own.*slot.from).file, slot);
        } catch (const InputError& e) {
            if (warned.insert(own.name + "\n" + e.what()).second)
                warn("material '{}': {}; drawn without it", own.name, e.what());
        }
    }
    for (const auto& [name, texture] : with.maps) {
        const size_t slot = find_slot(name);
        maps[slot] = load_map(images, find_asset(texture), map_slots()[slot]);
    }
    return maps;
}

}  // namespace lightwalk
