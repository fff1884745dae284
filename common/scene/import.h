// Models of every format but OBJ, through Assimp.
#pragma once
#include <filesystem>

#include "common/scene/mesh.h"

namespace lightwalk {

/// Reads glTF (.gltf, .glb), PLY, STL, Collada (.dae), FBX, 3DS, OFF, and OBJ as Assimp understands it. One Mesh for
/// each of the file's, all polygons as triangles, equal vertices joined, missing normals filled; the node tree with its
/// transforms and the first animation; materials with the paths of their textures. A texture inside the file is left
/// out with a warning on stderr. Assimp runs in a guarded process (common/base/guarded.h). Throws InputError: missing,
/// empty, unknown format, malformed, without a triangle, one that Assimp crashes on or takes too long or too much
/// memory for.
Model import_model(const std::filesystem::path& path);

}  // namespace lightwalk
