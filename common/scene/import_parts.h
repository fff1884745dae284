// The parts of a model that Assimp has read, each into the model's own.
#pragma once
#include <assimp/scene.h>

#include <filesystem>

#include "common/scene/mesh.h"

namespace lightwalk {

// Assimp's matrices are rows, glm's are columns.
inline glm::mat4 to_glm(const aiMatrix4x4& m) {
    return glm::transpose(glm::mat4(m.a1, m.a2, m.a3, m.a4, m.b1, m.b2, m.b3, m.b4,  //
                                    m.c1, m.c2, m.c3, m.c4, m.d1, m.d2, m.d3, m.d4));
}
inline glm::vec3 to_glm(const aiVector3D& v) { return {v.x, v.y, v.z}; }

/// At least one, with numbers in their range.
void add_import_materials(const aiScene& scene, const std::filesystem::path& path, Model& model);

/// The tree, in metres and with y up, and the first animation.
void add_import_nodes(const aiScene& scene, const std::string& name, const std::string& extension, Model& model);

/// `extension`: an STL file gets flat normals. Called after the nodes, which are joints.
void add_import_meshes(const aiScene& scene, const std::string& name, const std::string& extension, Model& model);

void add_import_cameras(const aiScene& scene, Model& model);

}  // namespace lightwalk
