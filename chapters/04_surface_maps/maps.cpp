#include "04_surface_maps/maps.h"

#include <bitset>
#include <cstring>
#include <glm/gtc/color_space.hpp>
#include <glm/gtc/packing.hpp>
#include <map>

#include "04_surface_maps/levels.h"
#include "04_surface_maps/tangents.h"
#include "common/base/shared_lock.h"
#include "common/image/image.h"

namespace lightwalk {
namespace {

constexpr double white_texels = 32.0;  // as in surface.frag

// Decoding and encoding of texels in the image's format: 8 or 16 bits, or halves; sRGB becomes linear.
class Codec {
  public:
    explicit Codec(VkFormat format) : format_(format) {}
    glm::vec4 decode(const std::byte* from) const {
        glm::vec4 value(0.0f);
        uint64_t wide = 0;
        uint32_t narrow = 0;
        std::memcpy(&wide, from, bytes());
        narrow = static_cast<uint32_t>(wide);
        if (format_ == VK_FORMAT_R16G16B16A16_UNORM) return glm::unpackUnorm4x16(wide);
        if (format_ == VK_FORMAT_R16G16B16A16_SFLOAT) return glm::unpackHalf4x16(wide);
        value = glm::unpackUnorm4x8(narrow);
        if (format_ == VK_FORMAT_R8G8B8A8_SRGB)
            for (int i = 0; i < 3; ++i) value[i] = srgb_to_linear(std::to_integer<uint8_t>(from[i]));
        return value;
    }
    void encode(glm::vec4 value, std::vector<std::byte>& to) const {
        if (format_ == VK_FORMAT_R8G8B8A8_SRGB)
            for (int i = 0; i < 3; ++i) value[i] = linear_to_srgb(value[i]);
        const uint64_t word = format_ == VK_FORMAT_R16_UNORM             ? glm::packUnorm1x16(value.r)
                              : format_ == VK_FORMAT_R16G16B16A16_UNORM  ? glm::packUnorm4x16(value)
                              : format_ == VK_FORMAT_R16G16B16A16_SFLOAT ? glm::packHalf4x16(value)
                                                                         : glm::packUnorm4x8(value);
        const auto* begin = reinterpret_cast<const std::byte*>(&word);
        to.insert(to.end(), begin, begin + bytes());
    }
    size_t bytes() const { return texel_bytes(format_); }

  private:
    VkFormat format_;
};

Level decoded(std::span<const std::byte> bytes, glm::uvec2 size, VkFormat format) {
    const Codec codec(format);
    Level level{size, {}};
    level.texels.reserve(bytes.size() / codec.bytes());
    for (size_t at = 0; at < bytes.size(); at += codec.bytes()) level.texels.push_back(codec.decode(&bytes[at]));
    return level;
}

std::vector<std::vector<std::byte>> encoded(const std::vector<Level>& levels, VkFormat format) {
    const Codec codec(format);
    std::vector<std::vector<std::byte>> bytes;
    for (const Level& level : levels) {
        bytes.emplace_back();
        for (const glm::vec4& texel : level.texels) codec.encode(texel, bytes.back());
    }
    return bytes;
}

std::shared_ptr<Image> upload_levels(Gpu& gpu, Image::Desc desc, const std::vector<Level>& levels) {
    desc.mips = static_cast<uint32_t>(levels.size());
    auto image = std::make_shared<Image>(gpu.device, desc);
    gpu.upload(*image, unlocked([&] { return encoded(levels, desc.format); }));
    return image;
}

// Height map: one level, the only one read, in 16 bits, since some devices interpolate 8-bit texels in steps of 1/255,
// which a ray sees as terraces.
std::shared_ptr<Image> upload_heights(Gpu& gpu, const Image& image, const Level& level) {
    return upload_levels(gpu, {.name = image.desc.name, .format = VK_FORMAT_R16_UNORM, .size = level.size}, {level});
}

// Displacement map: 16 bits as height maps, with mip levels.
std::shared_ptr<Image> upload_displacement(Gpu& gpu, const Image& image, Level level) {
    for (glm::vec4& texel : level.texels) texel.a = 1.0f;  // equal weights
    return upload_levels(gpu, {.name = image.desc.name, .format = VK_FORMAT_R16_UNORM, .size = level.size},
                         cutout_levels(gpu, level, -1.0f));
}

// Opacity map's channel as alpha.
std::vector<Level> opacity_levels(Gpu& gpu, Level level, float cutoff) {
    for (glm::vec4& texel : level.texels) texel.a = texel.r;
    std::vector<Level> levels = cutout_levels(gpu, level, cutoff);
    for (Level& l : levels)
        for (glm::vec4& texel : l.texels) texel = glm::vec4(texel.a);
    return levels;
}

Pipeline::Graphics with_vertex(Pipeline::Graphics desc, const char* vertex) {
    desc.vertex = vertex;
    return desc;
}

}  // namespace

SurfacePipelines::SurfacePipelines(const Pipeline::Graphics& desc)
    : loaded(graphics(with_vertex(desc, "04_surface_maps/surface.vert"))),
      displaced(graphics(with_vertex(desc, "04_surface_maps/displaced.vert"))) {}

Level read_level(Gpu& gpu, const Image& image) {
    const std::vector<std::byte> bytes = gpu.read_back(image);
    return unlocked([&] { return decoded(bytes, image.desc.size, image.desc.format); });
}

std::vector<std::vector<std::byte>> normal_map_levels(const DecodedTexture& texture) {
    return encoded(normal_levels(decoded(texture.levels.at(0), texture.desc.size, texture.desc.format)),
                   texture.desc.format);
}

Maps::Maps(Module& owner, std::string name)
    : Module(owner, std::move(name), "maps"), surface(owner, "surface"), lamps(owner, "lamps") {}

void Maps::prepare(Gpu& gpu, Scene& scene) {
    add_tangents(gpu, scene);
    with_holes_.clear();
    if (makes_levels) with_holes_ = make_mips(gpu, scene, coverage.is("kept") ? cutoff : -1.0f);
}

// Cached by combination: every item asks in every frame.
Macros Maps::variant(const DrawItem& item) const {
    const std::array<const Knob<bool>*, map_slot_count> in_order{
        &diffuse, &specular,  &emissive, &opacity,       &normal,       &height,
        &orm,     &occlusion, &gloss,    &detail_normal, &displacement, &metallic_roughness};
    const Mesh& own = item.model->model.meshes[item.mesh];
    const std::array<std::pair<const char*, bool>, 6> others{
        {{"MAPS_PLACED", item.maps.are_placed()},
         {"MAPS_SECOND_UVS", item.maps.use_second_uvs() && !own.second_uvs.empty()},
         {"MAPS_COLORS", vertex_colors && !own.colors.empty()},
         {"MAPS_TWO_SIDED", item.two_sided},
         {"MAPS_UNLIT", item.material.unlit},
         {"SURFACE_GGX", has_microfacets(item)}}};
    std::bitset<map_slot_count + others.size()> set;
    for (size_t i = 0; i < in_order.size(); ++i) set[i] = *in_order[i] && item.maps[i];
    for (size_t i = 0; i < others.size(); ++i) set[in_order.size() + i] = others[i].second;
    static thread_local std::map<unsigned long, Macros> variants;
    const auto [known, added] = variants.try_emplace(set.to_ulong());
    if (!added) return known->second;
    for (size_t i = 0; i < in_order.size(); ++i) known->second.set(in_order[i]->macro(), set[i] ? "1" : "0");
    for (const auto& [macro, value] : others) known->second.set(macro, value ? "1" : "0");
    return known->second;
}

bool Maps::has_holes(const DrawItem& item) const {
    const float own = item.material.alpha_cutoff;
    if (own == 0.0f) return false;
    if (own > 0.0f &&
        (item.material.opacity < 1.0f || own > 1.0f || !item.model->model.meshes[item.mesh].colors.empty()))
        return true;
    return (diffuse && with_holes_.contains(item.maps[MapSlot::diffuse].get())) ||
           (opacity && with_holes_.contains(item.maps[MapSlot::opacity].get()));
}

void Maps::draw(Raster& pass, const Scene& scene, const std::vector<Batch>& batches, const Pipeline& loaded,
                const Pipeline& displaced) const {
    // Shadow casters pass one pipeline for both: they are drawn as loaded.
    const bool cut_finely = mesh.is("displaced") && &loaded != &displaced;
    const glm::vec3 ambient = scene.ambient();
    for (const Batch& batch : batches) {
        pass.use(cut_finely ? displaced : loaded, variant(batch.item()));
        pass.set_if_present("ambient", ambient);
        if (cut_finely)
            draw_displaced(pass, batch);
        else
            pass.draw(batch);
    }
}

std::set<const Image*> make_mips(Gpu& gpu, Scene& scene, float cutoff) {
    std::map<std::tuple<const Image*, MapSlot, float>, std::shared_ptr<Image>> made;  // shared by many items
    std::set<const Image*> with_holes;
    for (DrawItem& item : scene.items)
        for (const MapSlot slot : {MapSlot::diffuse, MapSlot::opacity, MapSlot::normal, MapSlot::height,
                                   MapSlot::detail_normal, MapSlot::displacement}) {
            std::shared_ptr<Image>& image = item.maps[slot];
            if (!image) continue;
            const float own = item.material.alpha_cutoff;
            if (slot == MapSlot::diffuse && own == 0.0f && !item.material.blend) continue;  // alpha unused
            // The material's threshold is for alpha times opacity; the texture's alone is larger by that factor.
            const float least = cutoff < 0.0f || own <= 0.0f ? cutoff : own / std::max(item.material.opacity, 1e-3f);
            std::shared_ptr<Image>& entry = made[{image.get(), slot, least}];
            if (!entry) {
                if (slot == MapSlot::diffuse && !scene.images()->has_alpha(*image)) {
                    entry = image;
                    continue;
                }
                if (slot == MapSlot::normal || slot == MapSlot::detail_normal) {
                    std::shared_ptr<Image>& kept = scene.images(gpu).derived[{image.get(), normal_levels_name}];
                    if (!kept) {
                        const Level codes = read_level(gpu, *image);
                        kept = upload_levels(gpu, image->desc, unlocked([&] { return normal_levels(codes); }));
                    }
                    image = entry = kept;
                    continue;
                }
                const Level level = read_level(gpu, *image);
                if (slot == MapSlot::height)
                    entry = upload_heights(gpu, *image, level);
                else if (slot == MapSlot::displacement)
                    entry = upload_displacement(gpu, *image, level);
                else if (slot == MapSlot::opacity)
                    entry = upload_levels(gpu, image->desc, opacity_levels(gpu, level, least));
                else if (coverage(level, 1.0f) < 1.0)
                    entry = upload_levels(gpu, image->desc, cutout_levels(gpu, level, least));
                else
                    entry = image;
                if (slot == MapSlot::opacity || (slot == MapSlot::diffuse && entry != image))
                    with_holes.insert(entry.get());
            }
            image = entry;
        }
    return with_holes;
}

double mean_texels(const ImageRgb& picture) {
    double sum = 0, count = 0;
    for (const glm::vec3& pixel : picture.pixels)
        if (pixel.r >= 0.0f) {
            sum += double(pixel.r);
            ++count;
        }
    return count > 0 ? white_texels * sum / count : 0.0;
}

void Maps::draw_displaced(Raster& pass, const Batch& batch) const {
    const DrawItem& item = batch.item();
    const Part& part = item.model->model.meshes[item.mesh].parts[item.part];
    const struct {
        uint32_t first_index, subdivide;
        float height_m, wobble, scroll;
    } of_part{part.first_index, static_cast<uint32_t>(subdivide.value), height_m, wobble, scroll};
    pass.set("indices", item.model->indices[item.mesh]).set("part", of_part);
    batch.bind(pass);
    pass.draw(part.index_count * of_part.subdivide * of_part.subdivide, batch.count, batch.first);
}

}  // namespace lightwalk
