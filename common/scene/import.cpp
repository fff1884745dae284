#include "common/scene/import.h"

#include <assimp/DefaultIOSystem.h>
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
#include "common/scene/gltf.h"
#include "common/scene/import_parts.h"
#include "common/scene/model_bytes.h"
#include "common/scene/named_files.h"

namespace lightwalk {
namespace {
namespace fs = std::filesystem;

constexpr std::array<std::string_view, 10> formats = {".gltf", ".glb", ".ply", ".stl", ".dae",
                                                      ".fbx",  ".3ds", ".off", ".3mf", ".obj"};

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

Model import_here(const fs::path& path, const std::string& extension) {
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
    if (!scene && wrong.find("bad_alloc") != wrong.npos) throw std::bad_alloc();  // swallowed by the importer
    if (!scene && wrong.find("contains no faces") != wrong.npos)
        throw InputError("{}: a point cloud: it has no triangle, and points are not drawn", name);
    if (!scene) throw InputError("{}: {}", name, first_line(std::string(wrong)));
    if (scene->mNumMeshes == 0) throw InputError("{}: no triangle in the file", name);

    Model model;
    add_import_materials(*scene, path, model);
    add_import_nodes(*scene, extension, model);
    add_import_meshes(*scene, name, extension, model);
    add_import_cameras(*scene, model);
    deform_at_rest(model);
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
        if (extension == ".hgt" || extension == ".tif" || extension == ".tiff")
            throw InputError("{}: a height map or an image, expected a model; chapter 15 reads heights of a 16-bit PNG",
                             name);
        throw InputError("{}: unknown model format '{}'; there are: {}", name, extension, known);
    }
    if (bytes == 0) throw InputError("{}: the file is empty", name);
    check_counts(path, extension, bytes);
    const bool is_gltf = extension == ".gltf" || extension == ".glb";
    const char* const reader = is_gltf ? "the glTF reader" : "Assimp";
    Model model;
    read_bytes(run_guarded(name, reader, limits_for(bytes_to_import(path)),
                           [&] { return to_bytes(is_gltf ? read_gltf(path) : import_here(path, extension)); }),
               name, model);
    if (!model.left_out.empty()) warn_once(fmt::format("{}: left out: {}", name, left_out_text(model)));
    return model;
}

}  // namespace lightwalk
