// Texture cache: each file is decoded and uploaded once.
#pragma once
#include <filesystem>
#include <map>
#include <memory>

#include "common/gpu/gpu.h"
#include "common/scene/material.h"

namespace lightwalk {

/// Encoding of a texture: sRGB colour, or linear data such as normals and heights.
enum class TextureKind { color, data };

/// Processing of one or two texture files for a material slot.
struct TextureUse {
    enum class As {
        stored,
        normals,             ///< derived from heights, unless the image already holds normals
        roughness_metalness  ///< green: channel of `map`; blue: channel of `metalness`
    };
    TextureMap map;
    TextureKind kind = TextureKind::color;
    As as = As::stored;
    TextureMap metalness{};
    int channels = 1;

    std::string key() const;
    const std::filesystem::path& file() const { return map ? map.file : metalness.file; }
};

struct DecodedTexture {
    Image::Desc desc;
    int channels = 3;
    std::vector<std::vector<std::byte>> levels;
};

/// CPU part of ImagePool::load(); thread-safe. Throws InputError: missing, empty, damaged.
DecodedTexture decode_texture(const TextureUse& use);
inline DecodedTexture decode_texture(const std::filesystem::path& file, TextureKind kind) {
    return decode_texture(TextureUse{{.file = file}, kind});
}

class ImagePool {
  public:
    explicit ImagePool(Gpu& gpu) : gpu_(gpu) {}

    /// Reads 8- and 16-bit images (PNG, JPEG, …), .hdr and .pfm (clamped to half floats), with all mips. Colours are
    /// linearised, grey is replicated, missing alpha is 1. Throws InputError: missing, empty, damaged, larger than the
    /// device allows, or fewer than `channels` channels (1 grey, 2 grey and alpha, 3 colour).
    std::shared_ptr<Image> load(const std::filesystem::path& file, TextureKind kind, int channels = 1) {
        return load(TextureUse{.map = {.file = file}, .kind = kind, .channels = channels});
    }
    std::shared_ptr<Image> load(const TextureUse& use);

    /// Adds an image from decode_texture() that is already uploaded.
    void put(const TextureUse& use, const std::shared_ptr<Image>& image, int channels);

    /// Images that chapters derive from one of this pool, by name. Same lifetime as the pool's images.
    std::map<std::pair<const Image*, std::string>, std::shared_ptr<Image>> derived;

    std::shared_ptr<Image> constant(glm::vec4 value);

    bool has_alpha(const Image& image) const { return channels_.contains(&image) && channels_.at(&image) % 2 == 0; }

    void clear() { images_.clear(), channels_.clear(), derived.clear(); }
    size_t size() const { return images_.size(); }

  private:
    Gpu& gpu_;
    std::map<std::string, std::shared_ptr<Image>> images_;
    std::map<const Image*, int> channels_;
};

}  // namespace lightwalk
