// Models of every format but OBJ, through Assimp.
#pragma once
#include <filesystem>

#include "common/scene/mesh.h"

namespace lightwalk {

/// Whether the name ends as a model's does, in a format that is read; OBJ too.
bool is_model_file(const std::filesystem::path& file);

/// Reads glTF (.gltf, .glb), PLY, STL, Collada (.dae), FBX, 3DS, OFF, 3MF, and OBJ as Assimp understands it. One Mesh for
/// each of the file's, all polygons as triangles, equal vertices joined, missing normals filled; the node tree with its
/// transforms and the first animation; materials with their textures. What it leaves out is in Model::left_out. Assimp runs in a guarded process (common/base/guarded.h). Throws InputError: missing,
/// empty, unknown format, malformed, without a triangle, one that Assimp crashes on or takes too long or too much
/// memory for.
Model import_model(const std::filesystem::path& path);

}  // namespace lightwalk
