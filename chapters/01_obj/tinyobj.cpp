// Public single-threaded parser, for comparison. It does not promise correctly rounded floats.
#include <tiny_obj_loader.h>

#include <sstream>

#include "01_obj/lines.h"
#include "01_obj/loaders.h"

namespace lightwalk {
namespace {

// It neither fails on an index out of range nor corrects it.
uint32_t checked(int index, size_t count, bool required, const std::string& name) {
    const bool there = index >= 0 && static_cast<size_t>(index) < count;
    if (!there && !required) return none;
    if (!there) throw InputError("{}: tinyobjloader: index {} is out of range, there are {}", name, index + 1, count);
    return static_cast<uint32_t>(index);
}

// A stream over memory that is not copied.
struct View : std::streambuf {
    explicit View(std::string_view text) {
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
    View view(text);
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

}  // namespace lightwalk
