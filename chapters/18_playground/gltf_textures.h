// Textures of a glTF file that is being written.
#pragma once
#include "18_playground/gltf_writer.h"
#include "common/image/image.h"
#include "common/scene/image_pool.h"

namespace lightwalk {

/// Images that are PNG or JPEG files keep their names, or their bytes where a model's file has them; others are made.
class GltfTextures {
  public:
    explicit GltfTextures(GltfWriter& writer) : writer_(writer) {}

    /// A textureInfo.
    GltfWriter::json texture(const TextureUse& use);

    /// The colours of `color`, white where there are none, with the opacity in their alpha.
    GltfWriter::json texture(const std::optional<TextureUse>& color, const TextureUse& opacity);

  private:
    int image(const TextureUse& use);
    int sampler(const Sampler& from);
    std::filesystem::path beside(const std::string& what) const;
    std::string uri_of(const std::filesystem::path& file) const;

    GltfWriter& writer_;
    std::map<std::string, int> images_, textures_, samplers_;
    std::map<std::pair<std::string, std::string>, std::filesystem::path> cutouts_;
};

/// Colours with opacity in their alpha, the only place that glTF has for it: `color`'s own alpha times `opacity`'s red.
/// As large as the larger of both in each direction.
Image8 color_with_opacity(const Image8& color, const Image8& opacity);

/// A texture as a material uses it, in 8 bits. Throws InputError where it cannot be read.
Image8 picture_of(const TextureUse& use);

}  // namespace lightwalk
