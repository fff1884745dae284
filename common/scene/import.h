// Model files: glTF by the course's reader, other formats through Assimp.
#pragma once
#include <filesystem>

#include "common/scene/mesh.h"

namespace lightwalk {

/// True for extensions of supported model formats, including OBJ.
bool is_model_file(const std::filesystem::path& file);

/// Reads glTF (.gltf, .glb), and through Assimp PLY, STL, Collada (.dae), FBX, 3DS, OFF, 3MF and OBJ. One Mesh per mesh
/// of the file: triangulated, equal vertices joined, missing normals filled in. Also nodes, first animation, materials
/// and textures; other content is listed in Model::left_out. The reader runs in a guarded process
/// (common/base/guarded.h). Throws InputError: missing, empty, unknown or malformed file, no triangle, or a crash,
/// timeout or memory overrun of the reader.
Model import_model(const std::filesystem::path& path);

}  // namespace lightwalk
