// The parts of a glTF file, each into the model's own.
#pragma once
#include "common/scene/gltf_file.h"
#include "common/scene/mesh.h"

namespace lightwalk {

/// All materials, and the images inside the file that they name.
void read_gltf_materials(const GltfFile& file, Model& model);

/// Primitives that were read, without their materials: for each its number in Model::meshes.
using KnownPrimitives = std::map<nlohmann::json, uint32_t>;

/// Adds a mesh's primitives to the model as one Mesh each, and returns their numbers; `weights` of morph targets are the
/// mesh's. `default_material`: for primitives that name none.
std::vector<uint32_t> read_gltf_mesh(const GltfFile& file, size_t mesh, uint32_t default_material,
                                     KnownPrimitives& known, Model& model);

/// The first animation. `nodes`: of each of the file's nodes the model's, or -1.
void read_gltf_motions(const GltfFile& file, const std::vector<int>& nodes, Model& model);

/// Refuses a file that requires an extension which is not read (glTF 2.0, 3.12).
void check_gltf_required(const GltfFile& file);

/// Lists the file's extensions that are not drawn.
void list_gltf_extensions(const GltfFile& file, Model& model);

}  // namespace lightwalk
