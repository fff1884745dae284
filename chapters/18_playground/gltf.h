// Export to glTF 2.0.
#pragma once
#include <filesystem>
#include <string>

#include "18_playground/document.h"
#include "common/scene/scene.h"

namespace lightwalk {

/// Writes FILE.gltf and, beside it, FILE.bin: objects and the nodes of their models with names and transforms, meshes
/// (each once), materials (diffuse and ORM or roughness and metalness as metallic-roughness; normal, occlusion and
/// emissive maps and emissive strength; alpha mode and cutoff; sides; unlit; texture transforms and samplers), vertex
/// colours, point, spot and directional lights (KHR_lights_punctual), and the camera with its roll. Textures that are
/// PNG or JPEG are named by their own files, or stay in the buffer if the model's file contained them; an opacity map
/// becomes the alpha of FILE.cutout1.png and so on. Hidden entries are omitted. Writes all files, or none. Returns the
/// properties without a place in glTF, such as "specular colours (3 materials), environment". Throws InputError.
std::string export_gltf(const Document& document, const Scene& scene, const std::filesystem::path& file);

}  // namespace lightwalk
