// Text of PLY and OFF files: the parts that Assimp 5.2.5 reads wrongly or drops.
#pragma once
#include <string>
#include <string_view>

#include "common/scene/mesh.h"

namespace lightwalk {

/// The file as PLY that Assimp reads whole: vertices' `diffuse_red` become `red`. Names other properties and elements
/// as left out. Throws InputError: triangle strips.
std::string readable_ply(std::string text, const std::string& name, Model& model);

/// The same shape and colours as PLY: [ST][C][N][4]OFF of Geomview in text, with colours of vertices and faces. Throws
/// InputError: binary, other dimensions, counts beyond the file, numbers that are missing.
std::string off_as_ply(std::string_view text, const std::string& name, Model& model);

/// Colours of a binary STL's triangles, three equal ones each, as two programs store them in the attribute words:
/// VisCAM, and Materialise Magics, which marks them by "COLOR=" in the header. Empty where the file has none.
std::vector<glm::vec4> stl_colors(std::string_view bytes, Model& model);

}  // namespace lightwalk
