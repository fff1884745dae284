// Conversion of the parts of an Assimp scene to a Model.
#pragma once
#include <assimp/scene.h>

#include <filesystem>
#include <string>
#include <string_view>

#include "common/scene/mesh.h"

namespace lightwalk {

// Assimp is row-major, glm column-major.
inline glm::mat4 to_glm(const aiMatrix4x4& m) {
    return glm::transpose(glm::mat4(m.a1, m.a2, m.a3, m.a4, m.b1, m.b2, m.b3, m.b4,  //
                                    m.c1, m.c2, m.c3, m.c4, m.d1, m.d2, m.d3, m.d4));
}
inline glm::vec3 to_glm(const aiVector3D& v) { return {v.x, v.y, v.z}; }

/// Adds at least one material, with values clamped to their valid ranges.
void add_import_materials(const aiScene& scene, const std::filesystem::path& path, Model& model);

/// Adds the node tree, in metres with y up, and the first animation.
void add_import_nodes(const aiScene& scene, const std::string& name, const std::string& extension, Model& model);

/// Adds the meshes; call after add_import_nodes(), since joints are nodes. `extension`: STL meshes get flat normals.
void add_import_meshes(const aiScene& scene, const std::string& name, const std::string& extension, Model& model);

void add_import_cameras(const aiScene& scene, Model& model);

/// Unit of length in metres; adds ignored colours to Model::left_out. `bytes`: the 3MF file, a ZIP archive of XML.
float metres_of_3mf(std::string_view bytes, Model& model);

/// PLY that Assimp reads completely; other properties go to Model::left_out. Throws InputError for triangle strips.
std::string readable_ply(std::string text, const std::string& name, Model& model);

/// Converts [ST][C][N][4]OFF text (Geomview) to PLY. Throws InputError: binary, other dimensions, truncated.
std::string off_as_ply(std::string_view text, const std::string& name, Model& model);

/// Colours of a binary STL, three per triangle, by VisCAM's or Materialise Magics' convention; empty if it has none.
std::vector<glm::vec4> stl_colors(std::string_view bytes, Model& model);

/// OBJ text without a byte order mark, and with each material file of `folder` in an mtllib of its own.
std::string readable_obj(std::string_view text, const std::filesystem::path& folder);

}  // namespace lightwalk
