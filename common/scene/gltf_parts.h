// Conversion of the parts of a glTF file to a Model.
#pragma once
namespace draco {
class Mesh;
class PointAttribute;
}  // namespace draco
#include <memory>
#include <optional>

#include "common/scene/gltf_file.h"
#include "common/scene/mesh.h"

namespace lightwalk {

/// Reads .gltf and .glb: triangles, strips and fans, also quantised or compressed (Draco, meshoptimizer); both material
/// models; nodes, first animation, skins, morph targets, cameras, lights. Unsupported content is listed in
/// Model::left_out. Throws InputError, also for unsupported required extensions (glTF 2.0, 3.12).
Model read_gltf(const std::filesystem::path& path);
void read_gltf_materials(const GltfFile& file, Model& model);

/// Index in Model::meshes by primitive, ignoring its material.
using KnownPrimitives = std::map<nlohmann::json, uint32_t>;

/// Adds each primitive as a Mesh and returns their indices. `default_material`: for primitives without one.
std::vector<uint32_t> read_gltf_mesh(const GltfFile& file, size_t mesh, uint32_t default_material,
                                     KnownPrimitives& known, Model& model);

/// Adds the first animation. `nodes`: model node of each file node, or -1.
void read_gltf_motions(const GltfFile& file, const std::vector<int>& nodes, Model& model);

/// Throws InputError if the file requires an unsupported extension (glTF 2.0, 3.12).
void check_gltf_required(const GltfFile& file);

void list_gltf_extensions(const GltfFile& file, Model& model);

/// From x, y, z, w. Normalised integers leave a length that is not quite 1; a rotation has 1.
glm::quat unit_rotation(glm::vec4 q);

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
