#include "common/scene/import.h"

#include <assimp/DefaultIOSystem.h>
#include <assimp/GltfMaterial.h>
#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <algorithm>
#include <array>
#include <assimp/Importer.hpp>
#include <cctype>
#include <cmath>
#include <fstream>
#include <sstream>

#include "common/base/error.h"
#include "common/base/files.h"
#include "common/base/guarded.h"
#include "common/base/text.h"
#include "common/scene/asset_path.h"
#include "common/scene/model_bytes.h"
#include "common/scene/named_files.h"

namespace lightwalk {
namespace {
namespace fs = std::filesystem;

constexpr std::array<std::string_view, 9> formats = {".gltf", ".glb", ".ply", ".stl", ".dae",
                                                     ".fbx",  ".3ds", ".off", ".obj"};

// Assimp's matrices are rows, glm's are columns.
glm::mat4 to_glm(const aiMatrix4x4& m) {
    return glm::transpose(glm::mat4(m.a1, m.a2, m.a3, m.a4, m.b1, m.b2, m.b3, m.b4,  //
                                    m.c1, m.c2, m.c3, m.c4, m.d1, m.d2, m.d3, m.d4));
}

glm::vec3 to_glm(const aiVector3D& v) { return {v.x, v.y, v.z}; }

// Assimp makes room for the counts in the header of a PLY or OFF file before it looks whether the file is that long.
void check_counts(const fs::path& path, const std::string& extension, uintmax_t file_bytes) {
    if (extension != ".ply" && extension != ".off") return;
    std::ifstream in(path, std::ios::binary);
    std::string line;
    for (int i = 0; i < 200 && std::getline(in, line) && !line.starts_with("end_header"); ++i) {
        std::istringstream words(line);
        std::string word;
        if (extension == ".ply" && !(words >> word && word == "element" && words >> word)) continue;
        if (extension == ".off" && (line.starts_with('#') || !(words >> std::ws && std::isdigit(words.peek()))))
            continue;
        for (unsigned long long count; words >> count || !words.eof();)
            if (words.fail() || count > file_bytes)
                throw InputError("{}:{}: the header announces more elements than the file has bytes", path.string(),
                                 i + 1);
        if (extension == ".off") return;
    }
}

TextureMap texture(const aiMaterial& material, aiTextureType type, const aiScene& scene, const fs::path& path) {
    aiString file;
    if (material.GetTexture(type, 0, &file) != AI_SUCCESS || file.length == 0) return {};
    if (scene.GetEmbeddedTexture(file.C_Str())) {
        warn("{}: texture '{}' lies inside the model file, which is not supported; left out", path.string(),
             file.C_Str());
        return {};
    }
    const bool is_uri = path.extension() == ".gltf" || path.extension() == ".glb" || path.extension() == ".dae";
    TextureMap map;
    map.file = resolve_file(is_uri ? decode_uri(file.C_Str()) : file.C_Str(), path.parent_path());
    return map;
}

Material to_material(const aiMaterial& from, const aiScene& scene, const fs::path& path) {
    Material to;
    to.name = from.GetName().C_Str();
    const auto color = [&](const char* key, unsigned type, unsigned index, glm::vec3& value) {
        aiColor3D c;
        if (from.Get(key, type, index, c) == AI_SUCCESS) value = {c.r, c.g, c.b};
    };
    color(AI_MATKEY_COLOR_AMBIENT, to.ambient);
    color(AI_MATKEY_COLOR_DIFFUSE, to.diffuse);
    color(AI_MATKEY_BASE_COLOR, to.diffuse);
    color(AI_MATKEY_COLOR_SPECULAR, to.specular);
    color(AI_MATKEY_COLOR_EMISSIVE, to.emissive);
    from.Get(AI_MATKEY_SHININESS, to.shininess);
    from.Get(AI_MATKEY_OPACITY, to.opacity);
    from.Get(AI_MATKEY_REFRACTI, to.refraction);
    from.Get(AI_MATKEY_ROUGHNESS_FACTOR, to.roughness);
    from.Get(AI_MATKEY_METALLIC_FACTOR, to.metalness);
    aiString alpha;
    to.blend = from.Get(AI_MATKEY_GLTF_ALPHAMODE, alpha) == AI_SUCCESS && alpha == aiString("BLEND");
    static constexpr std::pair<aiTextureType, TextureMap Material::*> maps[] = {
        {aiTextureType_DIFFUSE, &Material::diffuse_map},
        {aiTextureType_BASE_COLOR, &Material::diffuse_map},
        {aiTextureType_SPECULAR, &Material::specular_map},
        {aiTextureType_AMBIENT, &Material::ambient_map},
        {aiTextureType_EMISSIVE, &Material::emissive_map},
        {aiTextureType_SHININESS, &Material::shininess_map},
        {aiTextureType_OPACITY, &Material::opacity_map},
        {aiTextureType_HEIGHT, &Material::bump_map},
        {aiTextureType_NORMALS, &Material::normal_map},
        {aiTextureType_DISPLACEMENT, &Material::displacement_map},
        {aiTextureType_METALNESS, &Material::metalness_map},
        {aiTextureType_DIFFUSE_ROUGHNESS, &Material::roughness_map}};
    for (const auto& [type, map] : maps)
        if (!(to.*map)) to.*map = texture(from, type, scene, path);
    return to;
}

bool is_finite(const glm::vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

Mesh to_mesh(const aiMesh& from, const std::string& file) {
    Mesh to;
    to.name = from.mName.C_Str();
    for (unsigned i = 0; i < from.mNumVertices; ++i) {
        Vertex vertex{to_glm(from.mVertices[i]), glm::vec3(0.0f), glm::vec2(0.0f)};
        if (from.HasNormals()) vertex.normal = to_glm(from.mNormals[i]);
        const float length = glm::length(vertex.normal);
        vertex.normal = length > 0.0f && std::isfinite(length) ? vertex.normal / length : glm::vec3(0.0f);
        if (from.HasTextureCoords(0) && is_finite(to_glm(from.mTextureCoords[0][i])))
            vertex.uv = glm::vec2(to_glm(from.mTextureCoords[0][i]));
        if (!is_finite(vertex.position)) throw InputError("{}: mesh '{}': position {} is not finite", file, to.name, i);
        to.bounds.add(vertex.position);
        to.vertices.push_back(vertex);
    }
    for (unsigned i = 0; i < from.mNumFaces; ++i) {
        const aiFace& face = from.mFaces[i];
        if (face.mNumIndices != 3) continue;  // points and lines
        to.indices.insert(to.indices.end(), face.mIndices, face.mIndices + 3);
    }
    to.parts = {{0, static_cast<uint32_t>(to.indices.size()), from.mMaterialIndex}};
    fill_missing_normals(to);
    return to;
}

// Parents before children. Without recursion: the depth of the tree is the file's choice.
std::vector<Node> to_nodes(const aiNode& root) {
    std::vector<Node> nodes;
    std::vector<std::pair<const aiNode*, int>> waiting = {{&root, -1}};
    while (!waiting.empty()) {
        const auto [from, parent] = waiting.back();
        waiting.pop_back();
        Node& to = nodes.emplace_back();
        to.name = from->mName.C_Str();
        to.parent = parent;
        to.local = to_glm(from->mTransformation);
        to.meshes.assign(from->mMeshes, from->mMeshes + from->mNumMeshes);
        for (unsigned i = from->mNumChildren; i-- > 0;)
            waiting.emplace_back(from->mChildren[i], static_cast<int>(nodes.size() - 1));
    }
    return nodes;
}

template <class T, class Key, class Convert>
std::vector<TimedValue<T>> to_values(const Key* keys, unsigned count, double ticks_per_s, Convert convert) {
    std::vector<TimedValue<T>> values;
    for (unsigned i = 0; i < count; ++i)
        values.push_back({static_cast<float>(keys[i].mTime / ticks_per_s), convert(keys[i].mValue)});
    return values;
}

// The file's first animation. A channel without positions, rotations or scales leaves the node's own.
void add_motions(const aiScene& scene, Model& model) {
    if (scene.mNumAnimations == 0 || !(scene.mAnimations[0]->mDuration > 0)) return;
    const aiAnimation& from = *scene.mAnimations[0];
    const double ticks_per_s = from.mTicksPerSecond > 0 ? from.mTicksPerSecond : 25;
    model.motions_s = static_cast<float>(from.mDuration / ticks_per_s);
    for (unsigned i = 0; i < from.mNumChannels; ++i) {
        const aiNodeAnim& channel = *from.mChannels[i];
        const auto node = std::find_if(model.nodes.begin(), model.nodes.end(),
                                       [&](const Node& n) { return n.name == channel.mNodeName.C_Str(); });
        const aiNode* own = scene.mRootNode->FindNode(channel.mNodeName);
        if (node == model.nodes.end() || !own) continue;
        aiVector3D scale, position;
        aiQuaternion rotation;
        own->mTransformation.Decompose(scale, rotation, position);
        const auto to_quat = [](const aiQuaternion& q) { return glm::quat(q.w, q.x, q.y, q.z); };
        const auto to_vec = [](const aiVector3D& v) { return to_glm(v); };
        NodeMotion motion{
            .node = static_cast<uint32_t>(node - model.nodes.begin()),
            .position = to_values<glm::vec3>(channel.mPositionKeys, channel.mNumPositionKeys, ticks_per_s, to_vec),
            .scale = to_values<glm::vec3>(channel.mScalingKeys, channel.mNumScalingKeys, ticks_per_s, to_vec),
            .rotation = to_values<glm::quat>(channel.mRotationKeys, channel.mNumRotationKeys, ticks_per_s, to_quat)};
        if (motion.position.empty()) motion.position = {{0, to_glm(position)}};
        if (motion.scale.empty()) motion.scale = {{0, to_glm(scale)}};
        if (motion.rotation.empty()) motion.rotation = {{0, to_quat(rotation)}};
        model.motions.push_back(std::move(motion));
    }
}

std::string first_line(std::string text) {
    text = text.substr(0, text.find_first_of("\r\n"));
    return text.empty() ? "cannot be read" : text;
}

// A model file names others, which may be pipes or devices as well as it may itself.
struct RegularFiles : Assimp::DefaultIOSystem {
    bool Exists(const char* file) const override {
        std::error_code error;
        return fs::is_regular_file(file, error);
    }
    Assimp::IOStream* Open(const char* file, const char* mode) override {
        return Exists(file) && mode[0] == 'r' ? DefaultIOSystem::Open(file, mode) : nullptr;
    }
};

Model import_here(const fs::path& path) {
    const std::string name = path.string();
    Assimp::Importer importer;
    importer.SetIOHandler(new RegularFiles);  // the importer deletes it
    importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE, aiPrimitiveType_POINT | aiPrimitiveType_LINE);
    importer.SetPropertyBool(AI_CONFIG_IMPORT_FBX_PRESERVE_PIVOTS, false);
    const aiScene* scene = nullptr;
    try {
        scene = importer.ReadFile(name, aiProcess_Triangulate | aiProcess_JoinIdenticalVertices |
                                            aiProcess_SortByPType | aiProcess_ValidateDataStructure);
    } catch (const std::bad_alloc&) { throw; } catch (const std::exception& failed) {
        throw InputError("{}: {}", name, first_line(failed.what()));
    }
    const std::string_view wrong = importer.GetErrorString();
    if (!scene && wrong.find("bad_alloc") != wrong.npos) throw std::bad_alloc();  // it catches what is for the guard
    if (!scene) throw InputError("{}: {}", name, first_line(std::string(wrong)));
    if (scene->mNumMeshes == 0) throw InputError("{}: no triangle in the file", name);

    Model model;
    for (unsigned i = 0; i < scene->mNumMaterials; ++i) {
        model.materials.push_back(to_material(*scene->mMaterials[i], *scene, path));
        limit_numbers(model.materials.back(), name);
    }
    if (model.materials.empty()) model.materials.emplace_back();
    for (unsigned i = 0; i < scene->mNumMeshes; ++i) model.meshes.push_back(to_mesh(*scene->mMeshes[i], name));
    model.nodes = to_nodes(*scene->mRootNode);
    add_motions(*scene, model);
    return model;
}

}  // namespace

Model import_model(const fs::path& path) {
    const std::string name = path.string();
    std::string extension = path.extension();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    const size_t bytes = InputFile(path).bytes;
    if (std::find(formats.begin(), formats.end(), extension) == formats.end()) {
        std::string known;
        for (const std::string_view format : formats) known += (known.empty() ? "" : ", ") + std::string(format);
        throw InputError("{}: unknown model format '{}'; there are: {}", name, extension, known);
    }
    if (bytes == 0) throw InputError("{}: the file is empty", name);
    check_counts(path, extension, bytes);
    Model model;
    read_bytes(
        run_guarded(name, "Assimp", limits_for(bytes_to_import(path)), [&] { return to_bytes(import_here(path)); }),
        name, model);
    return model;
}

}  // namespace lightwalk
