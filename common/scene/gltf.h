// glTF 2.0 models.
#pragma once
#include <filesystem>

#include "common/scene/mesh.h"

namespace lightwalk {

/// Reads .gltf and .glb: meshes (triangles, strips, fans; quantised and compressed by meshoptimizer; flat normals where
/// none are given), metallic-roughness and specular-glossiness materials with their textures, the node tree, the first
/// animation, skins, morph targets, cameras and lights. What else the file states is in Model::left_out. Throws
/// InputError, also where the file requires an extension that is not read (glTF 2.0, 3.12).
Model read_gltf(const std::filesystem::path& path);

}  // namespace lightwalk
