// The parts of a glTF file, each into the model's own.
#pragma once
#include "common/scene/gltf_file.h"
#include "common/scene/mesh.h"

namespace lightwalk {

/// All materials, and the images inside the file that they name.
void read_gltf_materials(const GltfFile& file, Model& model);

/// A mesh's primitives as one Mesh each; `weights` of morph targets are the mesh's. `default_material`: for
/// primitives that name none.
std::vector<Mesh> read_gltf_mesh(const GltfFile& file, size_t mesh, uint32_t default_material, Model& model);

/// The first animation. `nodes`: of each of the file's nodes the model's, or -1.
void read_gltf_motions(const GltfFile& file, const std::vector<int>& nodes, Model& model);

/// Refuses a file that requires an extension which is not read (glTF 2.0, 3.12).
void check_gltf_required(const GltfFile& file);

/// Lists the file's extensions that are not drawn.
void list_gltf_extensions(const GltfFile& file, Model& model);

}  // namespace lightwalk
