// Public parsers in a guarded process (common/base/guarded.h): on some files they crash or do not return.
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <tiny_obj_loader.h>

#include <assimp/Importer.hpp>
#include <sstream>

#include "01_obj/lines.h"
#include "01_obj/scan.h"
#include "common/base/bytes.h"
#include "common/base/error.h"
#include "common/base/guarded.h"

namespace lightwalk {

template <class Bytes>
void fields(Bytes& bytes, ObjData& data) {
    bytes(data.positions, data.uvs, data.normals, data.colors, data.corners, data.runs, data.objects, data.groups,
          data.materials, data.left_out, data.libraries);
}

namespace {

bool is_consistent(const ObjData& data) {
    const size_t positions = data.positions.size() / 3, uvs = data.uvs.size() / 2, normals = data.normals.size() / 3;
    if (data.corners.size() % 3 != 0) return false;
    for (const Corner& c : data.corners)
        if (c.position >= positions || (c.uv != none && c.uv >= uvs) || (c.normal != none && c.normal >= normals))
            return false;
    for (const Run& run : data.runs)
        if (run.first_triangle > data.triangles() || (run.material != none && run.material >= data.materials.size()) ||
            (run.object != none && run.object >= data.objects.size()))
            return false;
    for (const ColoredPosition& one : data.colors)
        if (one.position >= positions) return false;
    return true;
}

}  // namespace

ObjData parse_guarded(std::string_view text, const std::string& name, Loader loader) {
    const auto parse = loader == Loader::assimp ? parse_assimp : parse_tinyobjloader;
    const std::string reader(loader_name(loader));
    const std::string bytes = run_guarded(name, reader, limits_for(text.size()), [&] {
        ByteWriter writer;
        writer(parse(text, name));
        return std::move(writer.bytes);
    });
    ObjData data;
    ByteReader{bytes}(data);
    if (!is_consistent(data)) throw Failure("{}: {} returned an index that is out of range", name, reader);
    return data;
}

namespace {

// It neither fails on an index out of range nor corrects it.
uint32_t checked(int index, size_t count, bool required, const std::string& name) {
    const bool there = index >= 0 && static_cast<size_t>(index) < count;
    if (!there && !required) return none;
    if (!there) throw InputError("{}: tinyobjloader: index {} is out of range, there are {}", name, index + 1, count);
    return static_cast<uint32_t>(index);
}

// A stream over memory that is not copied.
struct TextBuffer : std::streambuf {
    explicit TextBuffer(std::string_view text) {
        char* begin = const_cast<char*>(text.data());
        setg(begin, begin, begin + text.size());
    }
};

}  // namespace

ObjData parse_tinyobjloader(std::string_view text, const std::string& name) {
    // It takes a material's number from the MTL file. We hand it one that has every name there is.
    ObjData data;
    std::string mtl;
    Statements statements(text.find("usemtl") == text.npos ? std::string_view() : text);
    std::map<std::string, int, std::less<>> numbers;
    for (std::string_view statement; statements.next(statement);) {
        const std::string_view keyword = next_word(statement);
        if (keyword == "mtllib") data.libraries.emplace_back(trim(statement));
        if (keyword != "usemtl" || numbers.contains(trim(statement))) continue;
        numbers.emplace(trim(statement), static_cast<int>(numbers.size()));
        data.materials.emplace_back(trim(statement));
    }

    struct NumberMaterials : tinyobj::MaterialReader {
        const std::vector<std::string>& names;
        explicit NumberMaterials(const std::vector<std::string>& n) : names(n) {}
        bool operator()(const std::string&, std::vector<tinyobj::material_t>* materials,
                        std::map<std::string, int>* numbers, std::string*, std::string*) override {
            for (const std::string& material : names) {
                numbers->emplace(material, static_cast<int>(materials->size()));
                materials->emplace_back().name = material;
            }
            return true;
        }
    } number_materials(data.materials);

    tinyobj::attrib_t attributes;
    std::vector<tinyobj::shape_t> shapes;
    std::vector<tinyobj::material_t> materials;
    std::string warning, error;
    TextBuffer view(text);
    std::istream in(&view);
    if (!tinyobj::LoadObj(&attributes, &shapes, &materials, &warning, &error, &in, &number_materials, true, false)) {
        const size_t end = error.find_first_of("\r\n");
        throw InputError("{}: tinyobjloader: {}", name, error.empty() ? "cannot read it" : error.substr(0, end));
    }
    data.positions = attributes.vertices;
    data.uvs = attributes.texcoords;
    data.normals = attributes.normals;
    const size_t positions = data.positions.size() / 3, uvs = data.uvs.size() / 2, normals = data.normals.size() / 3;
    for (const tinyobj::shape_t& shape : shapes)
        for (size_t i = 0; i < shape.mesh.indices.size(); ++i) {
            const tinyobj::index_t& index = shape.mesh.indices[i];
            if (i % 3 == 0) {
                const int material = shape.mesh.material_ids[i / 3];
                const uint32_t number = material < 0 ? none : static_cast<uint32_t>(material);
                if (data.runs.empty() || data.runs.back().material != number)
                    data.runs.push_back(
                        {.first_triangle = static_cast<uint32_t>(data.triangles()), .material = number});
            }
            data.corners.push_back({checked(index.vertex_index, positions, true, name),
                                    checked(index.texcoord_index, uvs, false, name),
                                    checked(index.normal_index, normals, false, name)});
        }
    return data;
}

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
