// Export to glTF 2.0.
#pragma once
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <span>
#include <string>

#include "18_playground/document.h"
#include "common/image/image.h"
#include "common/scene/image_pool.h"
#include "common/scene/scene.h"

namespace lightwalk {

struct GltfWriter {
    using json = nlohmann::ordered_json;

    std::filesystem::path target;
    json out;
    std::string bytes;                                   ///< of the buffer
    std::map<std::filesystem::path, std::string> files;  ///< images that are made here, beside the target
    std::set<std::string> extensions;

    /// Appends to a list of the file. Returns the place.
    int push(const char* list, json value) {
        out[list].push_back(std::move(value));
        return static_cast<int>(out[list].size()) - 1;
    }

    /// Bytes of the buffer as a view. `use`: the view's target, 0: none.
    int view(std::span<const std::byte> data, int use = 0) {
        while (bytes.size() % 4) bytes.push_back('\0');
        json own{{"buffer", 0}, {"byteOffset", bytes.size()}, {"byteLength", data.size()}};
        if (use) own["target"] = use;
        bytes.append(reinterpret_cast<const char*>(data.data()), data.size());
        return push("bufferViews", own);
    }
};

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

/// Writes FILE.gltf and, beside it, FILE.bin: objects and the nodes of their models with names and transforms, meshes
/// (each once), materials (diffuse and ORM or roughness and metalness as metallic-roughness; normal, occlusion and
/// emissive maps and emissive strength; alpha mode and cutoff; sides; unlit; texture transforms and samplers), vertex
/// colours, point, spot and directional lights (KHR_lights_punctual), and the camera with its roll. Textures that are
/// PNG or JPEG are named by their own files, or stay in the buffer if the model's file contained them; an opacity map
/// becomes the alpha of FILE.cutout1.png and so on. Hidden entries are omitted. Writes all files, or none. Returns the
/// properties without a place in glTF, such as "specular colours (3 materials), environment". Throws InputError.
std::string export_gltf(const Document& document, const Scene& scene, const std::filesystem::path& file);

}  // namespace lightwalk
