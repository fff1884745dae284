// glTF 2.0 models.
#pragma once
#include <filesystem>

#include "common/scene/mesh.h"

namespace lightwalk {

/// Reads .gltf and .glb: triangles, strips and fans, also quantised or compressed (Draco, meshoptimizer); both material
/// models; nodes, first animation, skins, morph targets, cameras, lights. Unsupported content is listed in
/// Model::left_out. Throws InputError, also for unsupported required extensions (glTF 2.0, 3.12).
Model read_gltf(const std::filesystem::path& path);

}  // namespace lightwalk
