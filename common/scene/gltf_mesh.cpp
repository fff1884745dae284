// glTF meshes: primitives, converted to triangles.
#include <cmath>
#include <set>

#include "common/scene/gltf_parts.h"

namespace lightwalk {
namespace {
using nlohmann::json;

constexpr int points = 0, lines = 1, line_loop = 2, line_strip = 3, triangles = 4, strip = 5, fan = 6;

std::vector<uint32_t> as_triangles(std::vector<uint32_t> corners, int mode) {
    if (mode == triangles) {
        corners.resize(corners.size() - corners.size() % 3);
        return corners;
    }
    std::vector<uint32_t> result;
    for (size_t i = 0; i + 2 < corners.size(); ++i) {
        const uint32_t a = corners[mode == fan ? 0 : i], b = corners[i + 1], c = corners[i + 2];
        if (mode == strip && i % 2 == 1)
            result.insert(result.end(), {b, a, c});
        else
            result.insert(result.end(), {a, b, c});
    }
    return result;
}

class PrimitiveReader {
  public:
    PrimitiveReader(const GltfFile& file, const json& from, Model& model)
        : file_(file), from_(from), attributes_(from.at("attributes")), model_(model) {
        if (const json* how = extension(from, "KHR_draco_mesh_compression")) draco_.emplace(file, *how);
    }

    Mesh read(const std::string& name, const json& weights) {
        Mesh mesh;
        mesh.name = name;
        read_positions(mesh.vertices);
        read_normals_and_uvs(mesh);
        read_colors(mesh);
        mesh.indices = indices();
        read_joints(mesh.deformation);
        read_targets(mesh.deformation, weights);
        check_indices(mesh);
        set_bounds(mesh);
        flatten_missing_normals(mesh);
        if (!mesh.deformation.joints.empty() || !mesh.deformation.targets.empty())
            mesh.deformation.rest = mesh.vertices;
        return mesh;
    }

  private:
    const size_t* find(const json& object, const std::string& key, size_t& index) const {
        const auto found = object.find(key);
        if (found == object.end()) return nullptr;
        index = found->get<size_t>();
        return &index;
    }

    template <class Vector>
    std::optional<std::vector<Vector>> unpacked(const std::string& key, size_t accessor) const {
        if (!draco_) return {};
        const size_t components = static_cast<size_t>(Vector::length());
        const bool is_normalized = value_or(file_.entry("accessors", accessor), "normalized", false);
        const auto floats = draco_->floats(key, components, is_normalized);
        if (!floats) return {};
        std::vector<Vector> result(floats->size() / components);
        if (!floats->empty())
            std::memcpy(static_cast<void*>(result.data()), floats->data(), floats->size() * sizeof(float));
        return result;
    }

    void check_count(const std::string& key, size_t count) const {
        if (count != count_) file_.refuse("{} has {} values for {} vertices", key, count, count_);
    }

    // Throws unless there is one value per vertex; empty if the attribute is absent.
    template <class Vector>
    std::vector<Vector> attribute(const json& object, const std::string& key) const {
        size_t index = 0;
        if (!find(object, key, index)) return {};
        auto compressed = &object == &attributes_ ? unpacked<Vector>(key, index) : std::nullopt;
        std::vector<Vector> result = compressed ? std::move(*compressed) : file_.vectors<Vector>(index);
        check_count(key, result.size());
        return result;
    }

    void read_positions(std::vector<Vertex>& vertices) {
        const size_t index = attributes_.at("POSITION").get<size_t>();
        const auto compressed = unpacked<glm::vec3>("POSITION", index);
        count_ = compressed ? compressed->size() : file_.length(index);
        vertices.resize(count_);
        set_member(vertices, &Vertex::position, index, compressed);
    }

    template <class Vector>
    bool read_member(std::vector<Vertex>& vertices, Vector Vertex::*member, const std::string& key) const {
        size_t index = 0;
        if (!find(attributes_, key, index)) return false;
        const auto compressed = unpacked<Vector>(key, index);
        check_count(key, compressed ? compressed->size() : file_.length(index));
        set_member(vertices, member, index, compressed);
        return true;
    }

    template <class Vector>
    void set_member(std::vector<Vertex>& vertices, Vector Vertex::*member, size_t accessor,
                    const std::optional<std::vector<Vector>>& compressed) const {
        if (compressed)
            for (size_t i = 0; i < count_; ++i) vertices[i].*member = (*compressed)[i];
        else if (count_ > 0)
            file_.read_into(accessor, &(vertices[0].*member), sizeof(Vertex));
    }

    void read_normals_and_uvs(Mesh& mesh) const {
        const bool has_normals = read_member(mesh.vertices, &Vertex::normal, "NORMAL");
        const bool has_uvs = read_member(mesh.vertices, &Vertex::uv, "TEXCOORD_0");
        mesh.second_uvs = attribute<glm::vec2>(attributes_, "TEXCOORD_1");
        for (glm::vec2& uv : mesh.second_uvs) uv = finite({uv.x, 1 - uv.y});
        for (Vertex& v : mesh.vertices) {
            if (has_normals) v.normal = normalized(v.normal);
            if (has_uvs) v.uv = finite({v.uv.x, 1 - v.uv.y});
        }
    }

    // Zero vectors are replaced later.
    static glm::vec3 normalized(glm::vec3 v) {
        const float length = glm::length(v);
        return length > 0 && std::isfinite(length) ? v / length : glm::vec3(0);
    }

    static glm::vec2 finite(glm::vec2 uv) { return std::isfinite(uv.x) && std::isfinite(uv.y) ? uv : glm::vec2(0); }

    void read_colors(Mesh& mesh) const {
        size_t index = 0;
        if (!find(attributes_, "COLOR_0", index)) return;
        if (file_.components(index) == 4) {
            mesh.colors = attribute<glm::vec4>(attributes_, "COLOR_0");
        } else {
            for (const glm::vec3& color : attribute<glm::vec3>(attributes_, "COLOR_0"))
                mesh.colors.emplace_back(color, 1);
        }
        for (glm::vec4& color : mesh.colors) color = glm::clamp(color, 0.0f, 1.0f);
    }

    std::vector<uint32_t> indices() const {
        std::vector<uint32_t> corners;
        size_t index = 0;
        if (draco_) return draco_->indices();
        if (find(from_, "indices", index)) {
            corners = file_.integers(index, 1);
        } else {
            for (uint32_t i = 0; i < count_; ++i) corners.push_back(i);
        }
        return as_triangles(std::move(corners), value_or(from_, "mode", triangles));
    }

    void read_joints(Deformation& how) const {
        size_t index = 0;
        if (!find(attributes_, "JOINTS_0", index)) return;
        const auto unpacked = draco_ ? draco_->integers("JOINTS_0", 4) : std::nullopt;
        const std::vector<uint32_t> joints = unpacked ? *unpacked : file_.integers(index, 4);
        how.joint_weights = attribute<glm::vec4>(attributes_, "WEIGHTS_0");
        if (joints.size() != 4 * count_ || how.joint_weights.size() != count_)
            file_.refuse("JOINTS_0 and WEIGHTS_0 have {} and {} values for {} vertices", joints.size() / 4,
                         how.joint_weights.size(), count_);
        for (size_t i = 0; i < count_; ++i) {
            how.joints.emplace_back(joints[4 * i], joints[4 * i + 1], joints[4 * i + 2], joints[4 * i + 3]);
            glm::vec4& w = how.joint_weights[i] = glm::max(how.joint_weights[i], 0.0f);
            const float sum = w.x + w.y + w.z + w.w;
            w = sum > 0 && std::isfinite(sum) ? w / sum : glm::vec4(1, 0, 0, 0);
        }
    }

    void read_targets(Deformation& how, const json& weights) const {
        const auto targets = from_.find("targets");
        if (targets == from_.end()) return;
        std::set<std::string> others;
        for (const json& from : *targets) {
            for (const auto& [key, value] : from.items())
                if (key != "POSITION" && key != "NORMAL" && key != "TANGENT") others.insert(key);
            MorphTarget target{attribute<glm::vec3>(from, "POSITION"), attribute<glm::vec3>(from, "NORMAL")};
            target.positions.resize(count_, glm::vec3(0));
            const size_t i = how.targets.size();
            how.weights.push_back(weights.is_array() && i < weights.size() ? weights[i].get<float>() : 0.0f);
            how.targets.push_back(std::move(target));
        }
        for (const std::string& key : others) leave_out(model_, "morph targets of " + key, "mesh");
    }

    void check_indices(const Mesh& mesh) const {
        for (const uint32_t i : mesh.indices)
            if (i >= count_) file_.refuse("mesh '{}': index {} of {} vertices", mesh.name, i, count_);
    }

    void set_bounds(Mesh& mesh) const {
        for (size_t i = 0; i < mesh.vertices.size(); ++i) {
            const glm::vec3 p = mesh.vertices[i].position;
            if (!(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z)))
                file_.refuse("mesh '{}': position {} is not finite", mesh.name, i);
            mesh.bounds.add(p);
        }
    }

    const GltfFile& file_;
    const json &from_, &attributes_;
    Model& model_;
    size_t count_ = 0;
    std::optional<DracoPrimitive> draco_;
};

void name_what_is_left(const json& attributes, Model& model) {
    if (attributes.contains("JOINTS_1")) leave_out(model, "more than four joints a vertex", "mesh");
    if (attributes.contains("COLOR_1")) leave_out(model, "second vertex colours", "mesh");
}

}  // namespace

std::vector<uint32_t> read_gltf_mesh(const GltfFile& file, size_t index, uint32_t default_material,
                                     KnownPrimitives& known, Model& model) {
    const json& from = file.entry("meshes", index);
    const std::string name = value_or<std::string>(from, "name", "");
    const json weights = from.contains("weights") ? from.at("weights") : json();
    std::vector<uint32_t> added;
    for (const json& primitive : from.at("primitives")) {
        const int mode = value_or(primitive, "mode", triangles);
        if (mode == points || mode == lines || mode == line_loop || mode == line_strip) {
            leave_out(model, mode == points ? "points" : "lines", "mesh");
            continue;
        }
        if (mode < 0 || mode > fan) file.refuse("mesh '{}': primitive mode {}", name, mode);
        if (!primitive.at("attributes").contains("POSITION")) {
            leave_out(model, "triangles without positions", "mesh");
            continue;
        }
        json surface = primitive;
        surface.erase("material");
        const auto same = known.find(surface);
        Mesh mesh = same == known.end() ? PrimitiveReader(file, primitive, model).read(name, weights)
                                        : model.meshes[same->second];
        name_what_is_left(primitive.at("attributes"), model);
        if (mesh.indices.empty()) continue;
        const uint32_t material = value_or(primitive, "material", default_material);
        if (material > default_material) file.refuse("material {} is named, there are {}", material, default_material);
        mesh.name = name;
        mesh.parts = {{0, static_cast<uint32_t>(mesh.indices.size()), material}};
        added.push_back(static_cast<uint32_t>(model.meshes.size()));
        if (!mesh.deformation) known.emplace(std::move(surface), added.back());
        model.meshes.push_back(std::move(mesh));
    }
    return added;
}

}  // namespace lightwalk
