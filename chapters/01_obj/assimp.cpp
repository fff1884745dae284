// Assimp's OBJ reader, for comparison: triangulates and joins equal vertices.
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <assimp/Importer.hpp>

#include "01_obj/loaders.h"
#include "common/base/error.h"

namespace lightwalk {

ObjData parse_assimp(std::string_view text, const std::string& name) {
    Assimp::Importer importer;
    const aiScene* scene = importer.ReadFileFromMemory(text.data(), text.size(),
                                                       aiProcess_Triangulate | aiProcess_JoinIdenticalVertices, "obj");
    if (!scene) {
        const std::string error = importer.GetErrorString();
        throw InputError("{}: assimp: {}", name, error.substr(0, error.find('\n')));
    }
    ObjData data;
    for (unsigned m = 0; m < scene->mNumMeshes; ++m) {
        const aiMesh& mesh = *scene->mMeshes[m];
        const uint32_t base = static_cast<uint32_t>(data.positions.size() / 3);
        const uint32_t uv_base = static_cast<uint32_t>(data.uvs.size() / 2);
        const uint32_t normal_base = static_cast<uint32_t>(data.normals.size() / 3);
        for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
            const auto append = [](std::vector<float>& to, const aiVector3D& from, int count) {
                to.insert(to.end(), &from.x, &from.x + count);
            };
            append(data.positions, mesh.mVertices[i], 3);
            if (mesh.HasTextureCoords(0)) append(data.uvs, mesh.mTextureCoords[0][i], 2);
            if (mesh.HasNormals()) append(data.normals, mesh.mNormals[i], 3);
        }
        data.runs.push_back({.first_triangle = static_cast<uint32_t>(data.triangles())});
        for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
            if (mesh.mFaces[f].mNumIndices != 3) continue;
            for (unsigned k = 0; k < 3; ++k) {
                const uint32_t i = mesh.mFaces[f].mIndices[k];
                data.corners.push_back({base + i, mesh.HasTextureCoords(0) ? uv_base + i : none,
                                        mesh.HasNormals() ? normal_base + i : none});
            }
        }
    }
    return data;
}

}  // namespace lightwalk
