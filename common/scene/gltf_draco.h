// KHR_draco_mesh_compression, decoded by Google's Draco library.
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
    /// `how`: the extension's JSON object. Throws InputError for damaged data.
    DracoPrimitive(const GltfFile& file, const nlohmann::json& how);
    ~DracoPrimitive();

    /// Values of an attribute such as "POSITION"; empty if not compressed. `is_normalized`: from the accessor.
    std::optional<std::vector<float>> floats(const std::string& attribute, size_t components, bool is_normalized) const;
    std::optional<std::vector<uint32_t>> integers(const std::string& attribute, size_t components) const;

    std::vector<uint32_t> indices() const;

  private:
    const draco::PointAttribute* find(const std::string& attribute, size_t components) const;

    const GltfFile& file_;
    nlohmann::json ids_;
    std::unique_ptr<draco::Mesh> mesh_;
};

}  // namespace lightwalk
