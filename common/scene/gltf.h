// glTF 2.0 models.
#pragma once
#include <filesystem>

#include "common/scene/mesh.h"

namespace lightwalk {

/// Reads .gltf and .glb: meshes (triangles, strips, fans; quantised, or compressed by Draco or meshoptimizer; flat normals if
/// none are given), metallic-roughness and specular-glossiness materials with textures, the node tree, the first
/// animation, skins, morph targets, cameras and lights. Other content is listed in Model::left_out. Throws
/// InputError, also if the file requires an unsupported extension (glTF 2.0, 3.12).
Model read_gltf(const std::filesystem::path& path);

}  // namespace lightwalk
