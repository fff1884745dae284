// Textures by file: each is decoded and uploaded once, however many materials name it.
#pragma once
#include <filesystem>
#include <map>
#include <memory>

#include "common/gpu/gpu.h"
#include "common/scene/material.h"

namespace lightwalk {

/// Meaning of a texture's numbers: sRGB-encoded colour, or linear data such as normals and heights.
enum class TextureKind { color, data };

/// Processing of one texture, or of two, for a slot of a material.
struct TextureUse {
    enum class As {
        stored,
        normals,             ///< of heights, unless the image holds normals
        roughness_metalness  ///< green of `map`'s channel, blue of `metalness`'
    };
    TextureMap map;  ///< its channel, base and gain are applied
    TextureKind kind = TextureKind::color;
    As as = As::stored;
    TextureMap metalness{};
    int channels = 1;  ///< that the file must have at least

    /// Equal keys give equal images.
    std::string key() const;
    const std::filesystem::path& file() const { return map ? map.file : metalness.file; }
};

/// A texture in memory, as the device takes it.
struct DecodedTexture {
    Image::Desc desc;
    int channels = 3;                            ///< of the file: 1 grey, 2 grey and alpha, 3 colour, 4 with alpha
    std::vector<std::vector<std::byte>> levels;  ///< all of them
};

/// The decoding part of ImagePool::load(), on any thread. Throws InputError: missing, empty, damaged.
DecodedTexture decode_texture(const TextureUse& use);
inline DecodedTexture decode_texture(const std::filesystem::path& file, TextureKind kind) {
    return decode_texture(TextureUse{{.file = file}, kind});
}

class ImagePool {
  public:
    explicit ImagePool(Gpu& gpu) : gpu_(gpu) {}

    /// 8- and 16-bit PNG, JPEG and the like, and .hdr and .pfm (clamped to halves), with all mips; colours become linear. Grey
    /// fills r, g and b; a missing alpha is 1. Throws InputError: missing, empty, damaged, larger than the device
    /// allows, or with fewer than `channels` channels (1 grey, 2 grey and alpha, 3 colour).
    std::shared_ptr<Image> load(const std::filesystem::path& file, TextureKind kind, int channels = 1) {
        return load(TextureUse{.map = {.file = file}, .kind = kind, .channels = channels});
    }
    std::shared_ptr<Image> load(const TextureUse& use);

    /// An image that was decoded by decode_texture() and is on the device already, for load() to find.
    void put(const TextureUse& use, const std::shared_ptr<Image>& image, int channels);

    /// A chapter's images derived from one of this pool, by name; kept as long as the pool's images.
    std::map<std::pair<const Image*, std::string>, std::shared_ptr<Image>> derived;

    /// One texel of that colour, for a slot without a texture.
    std::shared_ptr<Image> constant(glm::vec4 value);

    /// Whether the file of an image of this pool has an alpha channel.
    bool has_alpha(const Image& image) const { return channels_.contains(&image) && channels_.at(&image) % 2 == 0; }

    void clear() { images_.clear(), channels_.clear(), derived.clear(); }
    size_t size() const { return images_.size(); }

  private:
    Gpu& gpu_;
    std::map<std::string, std::shared_ptr<Image>> images_;
    std::map<const Image*, int> channels_;  ///< of the file
};

}  // namespace lightwalk
