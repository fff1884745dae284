// Meshes of Assimp scenes.
#include <algorithm>
#include <cmath>

#include "common/base/error.h"
#include "common/image/image.h"
#include "common/scene/import_parts.h"

namespace lightwalk {
namespace {

bool is_finite(const glm::vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

// Four largest bone weights per vertex. Joints are nodes of equal name: Assimp keeps no other link.
void add_bones(const aiMesh& from, const std::vector<Node>& nodes, Model& model, Mesh& to) {
    Deformation& how = to.deformation;
    how.joints.assign(from.mNumVertices, glm::uvec4(0));
    how.joint_weights.assign(from.mNumVertices, glm::vec4(0));
    ModelSkin skin;
    for (unsigned b = 0; b < from.mNumBones; ++b) {
        const aiBone& bone = *from.mBones[b];
        const auto node =
            std::find_if(nodes.begin(), nodes.end(), [&](const Node& n) { return n.name == bone.mName.C_Str(); });
        skin.joints.push_back(node == nodes.end() ? 0 : static_cast<uint32_t>(node - nodes.begin()));
        skin.inverse_bind.push_back(to_glm(bone.mOffsetMatrix));
        for (unsigned w = 0; w < bone.mNumWeights; ++w) {
            const aiVertexWeight& one = bone.mWeights[w];
            if (one.mVertexId >= from.mNumVertices) continue;
            glm::vec4& weights = how.joint_weights[one.mVertexId];
            int least = 0;
            for (int k = 1; k < 4; ++k)
                if (weights[k] < weights[least]) least = k;
            if (one.mWeight > weights[least]) {
                weights[least] = one.mWeight;
                how.joints[one.mVertexId][least] = b;
            }
        }
    }
    for (glm::vec4& w : how.joint_weights) {
        w = glm::max(w, 0.0f);
        const float sum = w.x + w.y + w.z + w.w;
        w = sum > 0 && std::isfinite(sum) ? w / sum : glm::vec4(1, 0, 0, 0);
    }
    how.rest = to.vertices;
    how.skin = static_cast<uint32_t>(model.skins.size());
    model.skins.push_back(std::move(skin));
}

// These formats use sRGB vertex colours; some exporters scale them to 255.
std::vector<glm::vec4> colors_of(const aiMesh& from) {
    std::vector<glm::vec4> colors;
    if (!from.HasVertexColors(0)) return colors;
    float most = 0, alphas = 0;
    for (unsigned i = 0; i < from.mNumVertices; ++i) {
        const aiColor4D& c = from.mColors[0][i];
        most = std::max({most, c.r, c.g, c.b});
        alphas = std::max(alphas, c.a);
    }
    const float one = most > 2.0f ? 255.0f : 1.0f;
    const auto linear = [&](float x) { return srgb_to_linear(std::clamp(x / one, 0.0f, 1.0f)); };
    for (unsigned i = 0; i < from.mNumVertices; ++i) {
        const aiColor4D& c = from.mColors[0][i];
        // Opacity 0 everywhere means absent alpha.
        const float alpha = alphas > 0 ? std::clamp(alphas > 2.0f ? c.a / 255.0f : c.a, 0.0f, 1.0f) : 1.0f;
        colors.emplace_back(linear(c.r), linear(c.g), linear(c.b), alpha);
    }
    return colors;
}

// `flat`: face normals instead of the file's.
Mesh to_mesh(const aiMesh& from, const std::string& file, bool flat) {
    Mesh to;
    to.name = from.mName.C_Str();
    for (unsigned i = 0; i < from.mNumVertices; ++i) {
        Vertex vertex{to_glm(from.mVertices[i]), glm::vec3(0.0f), glm::vec2(0.0f)};
        if (from.HasNormals() && !flat) vertex.normal = to_glm(from.mNormals[i]);
        const float length = glm::length(vertex.normal);
        vertex.normal = length > 0.0f && std::isfinite(length) ? vertex.normal / length : glm::vec3(0.0f);
        if (from.HasTextureCoords(0) && is_finite(to_glm(from.mTextureCoords[0][i])))
            vertex.uv = glm::vec2(to_glm(from.mTextureCoords[0][i]));
        if (!is_finite(vertex.position)) throw InputError("{}: mesh '{}': position {} is not finite", file, to.name, i);
        to.bounds.add(vertex.position);
        to.vertices.push_back(vertex);
        if (from.HasTextureCoords(1)) {
            const glm::vec3 uv = to_glm(from.mTextureCoords[1][i]);
            to.second_uvs.push_back(is_finite(uv) ? glm::vec2(uv) : glm::vec2(0));
        }
    }
    to.colors = colors_of(from);
    for (unsigned i = 0; i < from.mNumFaces; ++i) {
        const aiFace& face = from.mFaces[i];
        if (face.mNumIndices != 3) continue;
        to.indices.insert(to.indices.end(), face.mIndices, face.mIndices + 3);
    }
    to.parts = {{0, static_cast<uint32_t>(to.indices.size()), from.mMaterialIndex}};
    if (flat)
        flatten_missing_normals(to);
    else
        fill_missing_normals(to);
    return to;
}

}  // namespace

// Skinned meshes ignore their node's transform, so a node at the root holds them.
void add_import_meshes(const aiScene& scene, const std::string& name, const std::string& extension, Model& model) {
    std::vector<uint32_t> with_bones, numbers;
    const std::vector<Node> named = model.nodes;
    for (unsigned i = 0; i < scene.mNumMeshes; ++i) {
        const aiMesh& from = *scene.mMeshes[i];
        const bool is_drawn = (from.mPrimitiveTypes & aiPrimitiveType_TRIANGLE) != 0;
        numbers.push_back(is_drawn ? static_cast<uint32_t>(model.meshes.size()) : UINT32_MAX);
        if (!is_drawn) {
            leave_out(model, from.mPrimitiveTypes == aiPrimitiveType_POINT ? "points" : "lines", "mesh");
            continue;
        }
        model.meshes.push_back(to_mesh(from, name, extension == ".stl"));
        if (from.mNumAnimMeshes > 0) leave_out(model, "morph targets", "mesh");
        if (from.HasVertexColors(1)) leave_out(model, "second vertex colours", "mesh");
        if (from.HasTextureCoords(2)) leave_out(model, "texture coordinates 2", "mesh");
        if (!from.HasBones() || model.meshes.back().vertices.size() != from.mNumVertices) continue;
        add_bones(from, named, model, model.meshes.back());
        with_bones.push_back(numbers.back());
    }
    for (Node& node : model.nodes) {
        for (uint32_t& mesh : node.meshes) mesh = numbers[mesh];
        std::erase(node.meshes, UINT32_MAX);
    }
    if (with_bones.empty()) return;
    for (Node& node : model.nodes)
        std::erase_if(node.meshes, [&](uint32_t mesh) { return bool(model.meshes[mesh].deformation); });
    model.nodes.push_back({"skins", -1, glm::mat4(1), with_bones});
}

}  // namespace lightwalk
