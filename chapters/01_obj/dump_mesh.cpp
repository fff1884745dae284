#include <fmt/core.h>

#include <cstdio>
#include <nlohmann/json.hpp>

#include "01_obj/load_bench.h"
#include "common/base/files.h"

namespace lightwalk {
namespace {

using Json = nlohmann::ordered_json;

Json array(const glm::vec3& v) { return {v.x, v.y, v.z}; }

uint64_t hash_floats(const float* values, size_t count, uint64_t seed) {
    static_assert(std::endian::native == std::endian::little);
    return hash_bytes({reinterpret_cast<const char*>(values), count * sizeof(float)}, seed);
}

}  // namespace

std::string describe_mesh(const std::filesystem::path& path, Loader loader) {
    const Model model = load_model(path, loader);
    Json out = {{"file", path.string()}, {"loader", is_obj(path) ? loader_name(loader) : "assimp"}};
    uint64_t checksum = hash_bytes({});
    size_t vertices = 0, triangles = 0, positions = 0;
    for (const Mesh& mesh : model.meshes) {
        vertices += mesh.vertices.size();
        triangles += mesh.indices.size() / 3;
    }
    if (is_obj(path)) {
        const ObjData data = parse_obj(path, loader);
        checksum = hash_floats(data.positions.data(), data.positions.size(), checksum);
        positions = data.positions.size() / 3;
        out["uvs"] = data.uvs.size() / 2;
        out["normals"] = data.normals.size() / 3;
    } else {
        for (const Mesh& mesh : model.meshes)
            for (const Vertex& v : mesh.vertices) checksum = hash_floats(&v.position.x, 3, checksum);
        positions = vertices;
    }
    const Bounds bounds = model_bounds(model);
    out["positions"] = positions;
    out["vertices"] = vertices;
    out["triangles"] = triangles;
    out["meshes"] = model.meshes.size();
    out["nodes"] = model.nodes.size();
    out["bounds"] = {{"lower", array(bounds.lower)}, {"upper", array(bounds.upper)}};
    out["materials"] = Json::array();
    for (const Material& m : model.materials) out["materials"].push_back(m.name);
    out["positions_fnv1a64"] = fmt::format("{:016x}", checksum);
    return out.dump(2, ' ', false, Json::error_handler_t::replace);
}

void dump_mesh(const std::filesystem::path& path, Loader loader) {
    std::printf("%s\n", describe_mesh(path, loader).c_str());
}

}  // namespace lightwalk
