// Conversion of the parts of a glTF file to a Model.
#pragma once
#include "common/scene/gltf_file.h"
#include "common/scene/mesh.h"

namespace lightwalk {

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

}  // namespace lightwalk
