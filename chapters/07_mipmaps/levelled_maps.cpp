#include <map>

#include "07_mipmaps/exercises.h"
#include "07_mipmaps/level_view.h"
#include "common/image/image.h"
#include "common/image/mip_levels.h"

namespace lightwalk {
namespace {

// 8-bit RGBA only.
bool has_holes(VkFormat format, const std::vector<std::byte>& texels) {
    if (texel_bytes(format) != 4) return false;
    for (size_t i = 3; i < texels.size(); i += 4)
        if (texels[i] != std::byte(255)) return true;
    return false;
}

Content content_of_slot(MapSlot slot, bool holes) {
    switch (slot) {
        case MapSlot::diffuse:
            return holes ? Content::cutout : Content::srgb;
        case MapSlot::emissive:
            return Content::srgb;
        case MapSlot::normal:
        case MapSlot::detail_normal:
            return Content::normal;
        case MapSlot::orm:
            return Content::roughness;
        default:
            return Content::linear;
    }
}

}  // namespace

void LevelledMaps::prepare(Gpu& gpu, Scene& scene) {
    entries_.clear();
    uses_.clear();
    recorded_ = false;
    std::map<std::pair<const Image*, size_t>, std::shared_ptr<Entry>> made;
    for (uint32_t i = 0; i < scene.items.size(); ++i)
        for (size_t slot = 0; slot < map_slot_count; ++slot) {
            const std::shared_ptr<Image>& image = scene.items[i].maps[slot];
            if (!image) continue;
            std::shared_ptr<Entry>& entry = made[{image.get(), slot}];
            if (!entry) {
                std::vector<std::byte> texels = gpu.read_back(image->mip(0));
                Image::Desc desc = image->desc;
                desc.mips = 1;
                if (desc.format == VK_FORMAT_R16G16B16A16_SFLOAT && !is_hdr_name(desc.name)) {
                    texels = srgb_codes(texels);  // of the file: its levels are this chapter's subject
                    desc.format = VK_FORMAT_R8G8B8A8_SRGB;
                }
                const Content content = content_of_slot(MapSlot(slot), has_holes(desc.format, texels));
                if (content == Content::normal && texel_bytes(desc.format) == 4)
                    for (size_t t = 3; t < texels.size(); t += 4) texels[t] = std::byte(0);  // nothing lacks in length
                Image plain(gpu.device, desc);
                desc.mips = static_cast<uint32_t>(level_sizes(desc.size).size());
                desc.kept = true;
                entry = std::make_shared<Entry>(Entry{desc.name + ", " + map_slots()[slot].name, content,
                                                      std::move(plain), Image(gpu.device, desc)});
                gpu.upload(entry->plain, texels);
                std::vector<std::vector<std::byte>> levels{texels};  // the others black, until they are made
                for (uint32_t m = 1; m < desc.mips; ++m) levels.emplace_back(byte_count(entry->levels.mip(m)));
                gpu.upload(entry->levels, levels);
                entries_.push_back(entry);
            }
            uses_.push_back({i, slot, entry});
        }
}

void LevelledMaps::record(Frame& frame, MipChain& chain, float cutoff) {
    for (const auto& entry : entries_) chain.record(frame, entry->levels.all_mips(), entry->content, cutoff);
    recorded_ = true;
}

void LevelledMaps::use(Scene& scene, bool levels) const {
    for (const Use& use : uses_)
        scene.items[use.item].maps[use.slot] = {use.entry, levels ? &use.entry->levels : &use.entry->plain};
}

std::vector<Resource> LevelledMaps::reads() const {
    std::vector<Resource> reads;
    for (const auto& entry : entries_) reads.emplace_back(entry->levels);
    return reads;
}

}  // namespace lightwalk
