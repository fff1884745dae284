#include "common/scene/model_bytes.h"

#include <cmath>

#include "common/base/bytes.h"
#include "common/base/text.h"

namespace lightwalk {

template <class Bytes>
void fields(Bytes& bytes, TextureMap& map) {
    bytes(map.file, map.image, map.bump_multiplier, map.offset, map.scale, map.base_gain, map.clamp, map.channel,
          map.is_color, map.place, map.sampler);
}

template <class Bytes>
void fields(Bytes& bytes, Material& m) {
    bytes(m.name, m.ambient, m.diffuse, m.specular, m.emissive, m.shininess, m.opacity, m.transmission, m.refraction,
          m.roughness, m.metalness, m.blend, m.alpha_cutoff, m.sides, m.metallic_roughness, m.microfacets,
          m.has_exponent, m.unlit, m.normal_scale, m.occlusion_strength, m.illumination);
    for (TextureMap Material::*map : all_maps) bytes(m.*map);
}

template <class Bytes>
void fields(Bytes& bytes, MorphTarget& target) {
    bytes(target.positions, target.normals);
}

template <class Bytes>
void fields(Bytes& bytes, Deformation& how) {
    bytes(how.rest, how.targets, how.weights, how.joints, how.joint_weights, how.flat, how.skin, how.node);
}

template <class Bytes>
void fields(Bytes& bytes, Mesh& mesh) {
    bytes(mesh.name, mesh.vertices, mesh.second_uvs, mesh.colors, mesh.indices, mesh.parts, mesh.bounds,
          mesh.deformation);
}

template <class Bytes>
void fields(Bytes& bytes, Node& node) {
    bytes(node.name, node.parent, node.local, node.meshes, node.color);
}

template <class Bytes, class T>
void fields(Bytes& bytes, TimedValue<T>& value) {
    bytes(value.time_s, value.value);
}

template <class Bytes, class T>
void fields(Bytes& bytes, KeyTrack<T>& track) {
    bytes(static_cast<std::vector<TimedValue<T>>&>(track), track.between, track.slopes);
}

template <class Bytes>
void fields(Bytes& bytes, NodeMotion& motion) {
    bytes(motion.node, motion.position, motion.scale, motion.rotation, motion.weights);
}

template <class Bytes>
void fields(Bytes& bytes, ModelSkin& skin) {
    bytes(skin.joints, skin.inverse_bind);
}

template <class Bytes>
void fields(Bytes& bytes, FileCamera& camera) {
    bytes(camera.node, camera.camera, camera.name);
}

template <class Bytes>
void fields(Bytes& bytes, FileLight& light) {
    Light& l = light.light;
    bytes(light.node, l.kind, l.color, l.intensity, l.range_m, l.inner_rad, l.outer_rad, l.softness, l.name);
}

template <class Bytes>
void fields(Bytes& bytes, LeftOut& one) {
    bytes(one.what, one.count, one.unit);
}

void fields(ByteWriter& bytes, EncodedImage& image) { bytes(*image); }
void fields(ByteReader& bytes, EncodedImage& image) {
    std::vector<std::byte> read;
    bytes(read);
    image = std::make_shared<const std::vector<std::byte>>(std::move(read));
}

template <class Bytes>
void fields(Bytes& bytes, Model& model) {
    bytes(model.meshes, model.materials, model.nodes, model.motions, model.motions_s, model.skins, model.images,
          model.cameras, model.lights, model.left_out);
}

namespace {

bool is_consistent(const Mesh& mesh, size_t materials) {
    uint32_t largest = 0;
    for (const uint32_t index : mesh.indices) largest = std::max(largest, index);
    if (!mesh.indices.empty() && largest >= mesh.vertices.size()) return false;
    for (const Part& part : mesh.parts)
        if (uint64_t{part.first_index} + part.index_count > mesh.indices.size() || part.material >= materials)
            return false;
    const auto fits = [&](const auto& list) { return list.empty() || list.size() == mesh.vertices.size(); };
    const Deformation& how = mesh.deformation;
    for (const MorphTarget& target : how.targets)
        if (target.positions.size() != mesh.vertices.size() || !fits(target.normals)) return false;
    for (const glm::uvec3& corners : how.flat)
        if (std::max({corners.x, corners.y, corners.z}) >= mesh.vertices.size()) return false;
    return fits(mesh.second_uvs) && fits(how.flat) && fits(mesh.colors) && fits(how.rest) && fits(how.joints) &&
           how.joint_weights.size() == how.joints.size() && how.weights.size() == how.targets.size();
}

bool is_consistent(const Mesh& mesh, const Model& model) {
    const Deformation& how = mesh.deformation;
    if (!how) return true;
    if (how.node >= model.nodes.size()) return false;
    if (how.joints.empty()) return true;
    if (how.skin >= model.skins.size()) return false;
    const size_t joints = model.skins[how.skin].joints.size();
    return std::all_of(how.joints.begin(), how.joints.end(), [&](const glm::uvec4& j) {
        return std::max({j.x, j.y, j.z, j.w}) < joints;
    });
}

template <class T>
bool is_consistent(const KeyTrack<T>& track) {
    return track.between != Between::cubic || track.slopes.size() == 2 * track.size();
}

bool is_consistent(const NodeMotion& motion, const Model& model) {
    if (motion.node >= model.nodes.size() || motion.position.empty() != motion.scale.empty() ||
        motion.position.empty() != motion.rotation.empty())
        return false;
    for (const auto& [time_s, weights] : motion.weights)
        if (weights.size() != motion.weights[0].value.size()) return false;
    for (const auto& slopes : motion.weights.slopes)
        if (motion.weights.empty() || slopes.size() != motion.weights[0].value.size()) return false;
    return is_consistent(motion.position) && is_consistent(motion.scale) && is_consistent(motion.rotation) &&
           is_consistent(motion.weights);
}

bool is_consistent(const Model& model) {
    for (const Mesh& mesh : model.meshes)
        if (!is_consistent(mesh, model.materials.size()) || !is_consistent(mesh, model)) return false;
    for (const ModelSkin& skin : model.skins) {
        if (skin.joints.size() != skin.inverse_bind.size()) return false;
        for (const uint32_t joint : skin.joints)
            if (joint >= model.nodes.size()) return false;
    }
    for (const Material& material : model.materials)
        for (TextureMap Material::*map : all_maps)
            if ((material.*map).image >= static_cast<int>(model.images.size())) return false;
    for (const FileCamera& camera : model.cameras)
        if (camera.node >= model.nodes.size()) return false;
    for (const FileLight& light : model.lights)
        if (light.node >= model.nodes.size()) return false;
    for (size_t i = 0; i < model.nodes.size(); ++i) {
        if (model.nodes[i].parent < -1 || model.nodes[i].parent >= static_cast<int>(i)) return false;
        for (const uint32_t mesh : model.nodes[i].meshes)
            if (mesh >= model.meshes.size()) return false;
    }
    for (const NodeMotion& motion : model.motions)
        if (!is_consistent(motion, model)) return false;
    return true;
}

}  // namespace

std::string model_bytes(const Model& model) {
    ByteWriter writer;
    writer(model);
    return std::move(writer.bytes);
}

void read_bytes(std::string_view bytes, const std::string& file, Model& model) {
    ByteReader reader(bytes);
    reader(model);
    if (!is_consistent(model)) throw Failure("{}: its reader gave an index that is out of range", file);
    for (Material& material : model.materials)
        for (TextureMap Material::*map : all_maps)
            if (TextureMap& one = material.*map; one.image >= 0) one.bytes = model.images[size_t(one.image)];
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
    if (material.transmission != initial.transmission)
        for (int i = 0; i < 3; ++i) limit("transmission", material.transmission[i], 1, 1);
    limit("roughness", material.roughness, initial.roughness, 1);
    limit("metalness", material.metalness, initial.metalness, 1);
    material.alpha_cutoff = std::isnan(material.alpha_cutoff) ? -1.0f : std::min(material.alpha_cutoff, 1e4f);
    for (float* number : {&material.normal_scale, &material.occlusion_strength})
        *number = std::isnan(*number) ? 1.0f : std::clamp(*number, -1e4f, 1e4f);
    if (!changed.empty()) warn("{}: material '{}': {}", where, material.name, changed);
}

}  // namespace lightwalk
