#include "common/scene/import.h"

#include <assimp/DefaultIOSystem.h>
#include <assimp/MemoryIOWrapper.h>
#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <algorithm>
#include <array>
#include <assimp/Importer.hpp>
#include <fstream>
#include <sstream>

#include "common/base/error.h"
#include "common/base/files.h"
#include "common/base/guarded.h"
#include "common/base/names.h"
#include "common/base/text.h"
#include "common/image/image.h"
#include "common/scene/asset_path.h"
#include "common/scene/gltf_parts.h"
#include "common/scene/import_parts.h"
#include "common/scene/model_bytes.h"

namespace lightwalk {
namespace {
namespace fs = std::filesystem;

constexpr std::array<std::string_view, 10> formats = {".gltf", ".glb", ".ply", ".stl", ".dae",
                                                      ".fbx",  ".3ds", ".off", ".3mf", ".obj"};

// Assimp allocates memory for the counts in a PLY header without checking the file size.
void check_counts(const fs::path& path, uintmax_t file_bytes) {
    std::ifstream in(path, std::ios::binary);
    std::string line;
    for (int i = 0; i < 200 && std::getline(in, line) && !line.starts_with("end_header"); ++i) {
        std::istringstream words(line);
        std::string word;
        if (!(words >> word && word == "element" && words >> word)) continue;
        for (unsigned long long count; words >> count || !words.eof();)
            if (words.fail() || count > file_bytes)
                throw InputError("{}:{}: the header announces more elements than the file has bytes", path.string(),
                                 i + 1);
    }
}

std::string first_line(std::string text) {
    text = text.substr(0, text.find_first_of("\r\n"));
    return text.empty() ? "cannot be read" : text;
}

// Referenced files may be pipes or devices. One file may have another text here than on disk.
struct RegularFiles : Assimp::DefaultIOSystem {
    std::string replaced, text;
    RegularFiles(std::string of, std::string by) : replaced(std::move(of)), text(std::move(by)) {}
    bool Exists(const char* file) const override {
        std::error_code error;
        return fs::is_regular_file(file, error);
    }
    Assimp::IOStream* Open(const char* file, const char* mode) override {
        if (file == replaced)
            return new Assimp::MemoryIOStream(reinterpret_cast<const uint8_t*>(text.data()), text.size());
        return Exists(file) && mode[0] == 'r' ? DefaultIOSystem::Open(file, mode) : nullptr;
    }
};

bool can_join(const aiScene& scene) {
    return std::all_of(scene.mMeshes, scene.mMeshes + scene.mNumMeshes,
                       [](const aiMesh* mesh) { return !mesh->HasVertexColors(0) && !mesh->HasTextureCoords(1); });
}

bool has_triangles(const aiScene& scene) {
    return std::any_of(scene.mMeshes, scene.mMeshes + scene.mNumMeshes,
                       [](const aiMesh* mesh) { return (mesh->mPrimitiveTypes & aiPrimitiveType_TRIANGLE) != 0; });
}

// `colors`: sRGB, per triangle corner. They replace the material that Assimp derives from an STL header.
void set_colors(const std::vector<glm::vec4>& colors, Model& model) {
    if (model.meshes.size() != 1 || colors.empty() || model.meshes[0].indices.size() != colors.size()) return;
    Mesh& mesh = model.meshes[0];
    mesh.colors.assign(mesh.vertices.size(), glm::vec4(1));
    for (size_t i = 0; i < colors.size(); ++i)
        mesh.colors[mesh.indices[i]] = glm::vec4(srgb_to_linear(colors[i].r), srgb_to_linear(colors[i].g),
                                                 srgb_to_linear(colors[i].b), colors[i].a);
    for (Material& material : model.materials) {
        material = {{.name = material.name}};
        material.diffuse = glm::vec3(1);
    }
}

Model import_here(const fs::path& path, const std::string& extension) {
    const std::string name = path.string();
    Assimp::Importer importer;
    const bool is_obj = extension == ".obj";
    importer.SetIOHandler(
        new RegularFiles(is_obj ? name : "", is_obj ? readable_obj(read_file(path), path.parent_path()) : ""));
    importer.SetPropertyBool(AI_CONFIG_IMPORT_FBX_PRESERVE_PIVOTS, false);
    const aiScene* scene = nullptr;
    Model model;
    constexpr unsigned wanted = aiProcess_Triangulate | aiProcess_SortByPType | aiProcess_ValidateDataStructure;
    try {
        if (extension == ".ply" || extension == ".off") {
            const std::string text = extension == ".ply" ? readable_ply(read_file(path), name, model)
                                                         : off_as_ply(read_file(path), name, model);
            scene = importer.ReadFileFromMemory(text.data(), text.size(), wanted, "ply");
        } else {
            scene = importer.ReadFile(name, wanted);
        }
        // Assimp 5.2.5 wrongly joins vertices that differ only in colour or second coordinates.
        if (scene && can_join(*scene)) scene = importer.ApplyPostProcessing(aiProcess_JoinIdenticalVertices);
    } catch (const InputError&) { throw; } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& failed) { throw InputError("{}: {}", name, first_line(failed.what())); }
    const std::string_view wrong = importer.GetErrorString();
    if (!scene && wrong.find("bad_alloc") != wrong.npos) throw std::bad_alloc();  // caught by Assimp
    if (!scene && wrong.find("contains no faces") != wrong.npos)
        throw InputError("{}: a point cloud: it has no triangle, and points are not drawn", name);
    if (!scene) throw InputError("{}: {}", name, first_line(std::string(wrong)));
    if (!has_triangles(*scene)) throw InputError("{}: no triangle in the file", name);

    add_import_materials(*scene, path, model);
    add_import_nodes(*scene, name, extension, model);
    add_import_meshes(*scene, name, extension, model);
    if (extension == ".stl") set_colors(stl_colors(read_file(path), model), model);
    add_import_cameras(*scene, model);
    deform_at_rest(model);
    return model;
}

bool is_gltf(std::string_view extension) { return extension == ".gltf" || extension == ".glb"; }

}  // namespace

bool is_model_file(const fs::path& file) {
    return std::find(formats.begin(), formats.end(), lowercase(file.extension().string())) != formats.end();
}

Model import_model(const fs::path& path) {
    const std::string name = path.string(), extension = lowercase(path.extension().string());
    const size_t bytes = InputFile(path).bytes;
    if (!is_model_file(path)) {
        std::string known;
        for (const std::string_view format : formats) known += (known.empty() ? "" : ", ") + std::string(format);
        if (extension == ".hgt" || extension == ".tif" || extension == ".tiff")
            throw InputError(
                "{}: a height map or an image, expected a model; chapter 15 reads heights of .hgt and of a 16-bit PNG",
                name);
        throw InputError("{}: unknown model format '{}'; there are: {}", name, extension, known);
    }
    if (bytes == 0) throw InputError("{}: the file is empty", name);
    if (extension == ".ply") check_counts(path, bytes);
    Model model;
    const bool gltf = is_gltf(extension);
    const std::string said =
        run_guarded(name, gltf ? "the glTF reader" : "Assimp", limits_for(bytes_to_import(path)),
                    [&] { return model_bytes(gltf ? read_gltf(path) : import_here(path, extension)); });
    read_bytes(said, name, model);
    if (!model.left_out.empty()) warn_once(fmt::format("{}: left out: {}", name, left_out_text(model)));
    return model;
}

}  // namespace lightwalk
