// Preprocessing of PLY, OFF, STL and OBJ files that Assimp 5.2.5 reads incorrectly.
#pragma once
#include <filesystem>
#include <string>
#include <string_view>

#include "common/scene/mesh.h"

namespace lightwalk {

/// PLY that Assimp reads completely; other properties go to Model::left_out. Throws InputError for triangle strips.
std::string readable_ply(std::string text, const std::string& name, Model& model);

/// Converts [ST][C][N][4]OFF text (Geomview) to PLY. Throws InputError: binary, other dimensions, truncated.
std::string off_as_ply(std::string_view text, const std::string& name, Model& model);

/// Colours of a binary STL, three per triangle, by VisCAM's or Materialise Magics' convention; empty if it has none.
std::vector<glm::vec4> stl_colors(std::string_view bytes, Model& model);

/// OBJ text without a byte order mark, and with each material file of `folder` in an mtllib of its own.
std::string readable_obj(std::string_view text, const std::filesystem::path& folder);

}  // namespace lightwalk
