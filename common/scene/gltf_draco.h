// KHR_draco_mesh_compression: a primitive with compressed attributes and indices.
#pragma once
#include <memory>
#include <optional>

#include "common/scene/gltf_file.h"

namespace draco {
class Mesh;
class PointAttribute;
}  // namespace draco

namespace lightwalk {

class DracoPrimitive {
  public:
    /// `how`: the extension's object. Throws InputError where the bytes are damaged.
    DracoPrimitive(const GltfFile& file, const nlohmann::json& how);
    ~DracoPrimitive();

    /// The numbers of an attribute such as "POSITION", `components` each; nothing where it is not compressed.
    /// `is_normalized`: the accessor's.
    std::optional<std::vector<float>> floats(const std::string& attribute, size_t components, bool is_normalized) const;
    std::optional<std::vector<uint32_t>> integers(const std::string& attribute, size_t components) const;

    /// Of triangles.
    std::vector<uint32_t> indices() const;

  private:
    const draco::PointAttribute* find(const std::string& attribute, size_t components) const;

    const GltfFile& file_;
    nlohmann::json ids_;
    std::unique_ptr<draco::Mesh> mesh_;
};

}  // namespace lightwalk
