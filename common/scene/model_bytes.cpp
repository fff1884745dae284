#include "common/scene/model_bytes.h"

#include <cmath>

#include "common/base/bytes.h"
#include "common/base/text.h"

namespace lightwalk {

template <class Bytes>
void fields(Bytes& bytes, TextureMap& map) {
    bytes(map.file, map.bump_multiplier, map.offset, map.scale, map.base_gain, map.clamp, map.channel);
}

template <class Bytes>
void fields(Bytes& bytes, Material& m) {
    bytes(m.name, m.ambient, m.diffuse, m.specular, m.emissive, m.shininess, m.opacity, m.refraction, m.roughness,
          m.metalness, m.blend, m.illumination, m.diffuse_map, m.specular_map, m.ambient_map, m.emissive_map,
          m.shininess_map, m.opacity_map, m.bump_map, m.normal_map, m.displacement_map, m.roughness_map,
          m.metalness_map);
}

template <class Bytes>
void fields(Bytes& bytes, Mesh& mesh) {
    bytes(mesh.name, mesh.vertices, mesh.indices, mesh.parts, mesh.bounds);
}

template <class Bytes>
void fields(Bytes& bytes, Node& node) {
    bytes(node.name, node.parent, node.local, node.meshes);
}

template <class Bytes>
void fields(Bytes& bytes, NodeMotion& motion) {
    bytes(motion.node, motion.position, motion.scale, motion.rotation);
}

template <class Bytes>
void fields(Bytes& bytes, Model& model) {
    bytes(model.meshes, model.materials, model.nodes, model.motions, model.motions_s);
}

std::string to_bytes(const Model& model) {
    ByteWriter writer;
    writer(model);
    return std::move(writer.bytes);
}

namespace {

bool is_consistent(const Mesh& mesh, size_t materials) {
    uint32_t largest = 0;
    for (const uint32_t index : mesh.indices) largest = std::max(largest, index);
    if (!mesh.indices.empty() && largest >= mesh.vertices.size()) return false;
    for (const Part& part : mesh.parts)
        if (uint64_t{part.first_index} + part.index_count > mesh.indices.size() || part.material >= materials)
            return false;
    return true;
}

bool is_consistent(const Model& model) {
    for (const Mesh& mesh : model.meshes)
        if (!is_consistent(mesh, model.materials.size())) return false;
    for (size_t i = 0; i < model.nodes.size(); ++i) {
        if (model.nodes[i].parent < -1 || model.nodes[i].parent >= static_cast<int>(i)) return false;
        for (const uint32_t mesh : model.nodes[i].meshes)
            if (mesh >= model.meshes.size()) return false;
    }
    for (const NodeMotion& motion : model.motions)
        if (motion.node >= model.nodes.size() || motion.position.empty() || motion.scale.empty() ||
            motion.rotation.empty())
            return false;
    return true;
}

}  // namespace

void read_bytes(std::string_view bytes, const std::string& file, Model& model) {
    ByteReader reader(bytes);
    reader(model);
    if (!is_consistent(model)) throw Failure("{}: its reader gave an index that is out of range", file);
}

void limit_numbers(Material& material, const std::string& where) {
    const Material initial;
    std::string changed;
    const auto limit = [&](const char* name, float& value, float otherwise, float most) {
        const float now = std::isnan(value) ? otherwise : std::clamp(value, 0.0f, most);
        if (now != value)
            changed += fmt::format("{}{} {} is drawn as {}", changed.empty() ? "" : ", ", name, value, now);
        value = now;
    };
    const auto limit_color = [&](const char* name, glm::vec3& value, const glm::vec3& otherwise) {
        for (int i = 0; i < 3; ++i) limit(name, value[i], otherwise[i], 1e4f);
    };
    limit_color("ambient", material.ambient, initial.ambient);
    limit_color("diffuse", material.diffuse, initial.diffuse);
    limit_color("specular", material.specular, initial.specular);
    limit_color("emissive", material.emissive, initial.emissive);
    limit("shininess", material.shininess, initial.shininess, 1e5f);
    limit("opacity", material.opacity, initial.opacity, 1);
    limit("roughness", material.roughness, initial.roughness, 1);
    limit("metalness", material.metalness, initial.metalness, 1);
    if (!changed.empty()) warn("{}: material '{}': {}", where, material.name, changed);
}

}  // namespace lightwalk
