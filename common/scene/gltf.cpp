#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/gtc/type_ptr.hpp>

#include "common/base/text.h"
#include "common/scene/gltf_parts.h"
#include "common/scene/model_bytes.h"

namespace lightwalk {
namespace {
using nlohmann::json;

glm::mat4 local_of(const json& node) {
    if (const auto m = node.find("matrix"); m != node.end()) {
        glm::mat4 matrix;
        for (int i = 0; i < 16; ++i) matrix[i / 4][i % 4] = m->at(size_t(i)).get<float>();
        return matrix;
    }
    const glm::quat q = unit_rotation(vector_or(node, "rotation", glm::vec4(0, 0, 0, 1)));
    const glm::mat4 moved = glm::translate(glm::mat4(1), vector_or(node, "translation", glm::vec3(0)));
    return glm::scale(moved * glm::mat4_cast(q), vector_or(node, "scale", glm::vec3(1)));
}

class GltfReader {
  public:
    explicit GltfReader(const std::filesystem::path& path) : file_(path) {}

    Model read() {
        check_gltf_required(file_);
        read_gltf_materials(file_, model_);
        read_nodes();
        for (size_t i = 0; i < file_.count("nodes"); ++i)
            if (nodes_[i] >= 0 && in_scene_[i]) fill_node(i);
        read_gltf_motions(file_, nodes_, model_);
        name_moving();
        list_gltf_extensions(file_, model_);
        if (file_.count("scenes") > 1) leave_out(model_, "further scenes");
        if (model_.meshes.empty()) {
            const std::string left_out = left_out_text(model_);
            file_.refuse("no triangle in the file{}{}", left_out.empty() ? "" : "; left out: ", left_out);
        }
        drop_unused_default();
        for (Material& material : model_.materials) limit_numbers(material, file_.path.string());
        deform_at_rest(model_);
        return std::move(model_);
    }

  private:
    // Parents before children. Iterative, since files may nest arbitrarily deep.
    void read_nodes() {
        nodes_.assign(file_.count("nodes"), -1);
        const std::vector<int> parents = parents_of_nodes();
        const size_t scene = value_or<size_t>(file_.root, "scene", 0);
        std::vector<std::pair<size_t, int>> waiting;
        if (file_.count("scenes") > 0) {
            const json& from = file_.entry("scenes", scene);
            if (from.contains("nodes"))
                for (const json& root : from.at("nodes")) waiting.emplace_back(root.get<size_t>(), -1);
        } else {
            for (size_t i = 0; i < nodes_.size(); ++i)
                if (parents[i] < 0) waiting.emplace_back(i, -1);
        }
        std::reverse(waiting.begin(), waiting.end());
        add_trees(std::move(waiting));
        for (const int node : nodes_) in_scene_.push_back(node >= 0);
        // Joints may lie outside the scene, or be hidden: their trees give transforms, but are not drawn.
        for (size_t i = 0; i < file_.count("skins"); ++i)
            for (const json& joint : file_.entry("skins", i).at("joints")) {
                size_t root = joint.get<size_t>();
                if (root >= nodes_.size() || nodes_[root] >= 0) continue;
                const auto is_missing = [&](int node) { return node >= 0 && nodes_[size_t(node)] < 0; };
                for (size_t up = 0; is_missing(parents[root]) && up < nodes_.size(); ++up) root = size_t(parents[root]);
                if (is_missing(parents[root])) continue;  // its own ancestor
                add_trees({{root, parents[root] < 0 ? -1 : nodes_[size_t(parents[root])]}}, true);
            }
    }

    std::vector<int> parents_of_nodes() const {
        std::vector<int> parents(nodes_.size(), -1);
        for (size_t i = 0; i < nodes_.size(); ++i)
            if (const json& node = file_.entry("nodes", i); node.contains("children"))
                for (const json& child : node.at("children"))
                    if (const size_t c = child.get<size_t>(); c < nodes_.size()) parents[c] = static_cast<int>(i);
        return parents;
    }

    void add_trees(std::vector<std::pair<size_t, int>> waiting, bool with_hidden = false) {
        while (!waiting.empty()) {
            const auto [number, parent] = waiting.back();
            waiting.pop_back();
            const json& from = file_.entry("nodes", number);
            if (nodes_[number] >= 0) file_.refuse("node {} has two parents, or is its own", number);
            if (const json* visibility = extension(from, "KHR_node_visibility");
                visibility && !with_hidden && !value_or(*visibility, "visible", true))
                continue;
            nodes_[number] = static_cast<int>(model_.nodes.size());
            model_.nodes.push_back({value_or<std::string>(from, "name", ""), parent, local_of(from), {}});
            if (const auto children = from.find("children"); children != from.end())
                for (size_t i = children->size(); i-- > 0;)
                    waiting.emplace_back(children->at(i).get<size_t>(), nodes_[number]);
        }
    }

    void fill_node(size_t number) {
        const json& from = file_.entry("nodes", number);
        const auto node = static_cast<uint32_t>(nodes_[number]);
        if (from.contains("mesh")) add_mesh(from, node);
        if (from.contains("camera")) add_camera(file_.entry("cameras", from.at("camera").get<size_t>()), node);
        if (const json* light = extension(from, "KHR_lights_punctual"))
            add_light(light->at("light").get<size_t>(), node);
    }

    // A file's cameras and lights stand as at 0 s.
    void name_moving() {
        std::vector<bool> moves(model_.nodes.size(), false);
        for (const NodeMotion& motion : model_.motions) moves[motion.node] = !motion.position.empty();
        for (size_t i = 0; i < moves.size(); ++i)
            if (const int parent = model_.nodes[i].parent; parent >= 0 && moves[size_t(parent)]) moves[i] = true;
        for (const FileCamera& camera : model_.cameras)
            if (moves[camera.node]) leave_out(model_, "motions of cameras", "camera");
        for (const FileLight& light : model_.lights)
            if (moves[light.node]) leave_out(model_, "motions of lights", "light");
    }

    void drop_unused_default() {
        const size_t last = model_.materials.size() - 1;
        for (const Mesh& mesh : model_.meshes)
            for (const Part& part : mesh.parts)
                if (part.material == last) return;
        model_.materials.pop_back();
    }

    // Shared between nodes unless deformed.
    void add_mesh(const json& from, uint32_t node) {
        const size_t number = from.at("mesh").get<size_t>();
        const auto known = shared_.find(number);
        std::vector<uint32_t> added;
        if (known != shared_.end()) {
            added = known->second;
        } else {
            const uint32_t none = static_cast<uint32_t>(model_.materials.size() - 1);
            added = read_gltf_mesh(file_, number, none, primitives_, model_);
            bool is_deformed = false;
            for (const uint32_t i : added)
                if (Deformation& how = model_.meshes[i].deformation) {
                    set_deformation(from, node, how);
                    is_deformed = true;
                }
            if (!is_deformed) shared_[number] = added;
        }
        const uint32_t home = from.contains("skin") ? skin_home() : node;
        std::vector<uint32_t>& meshes = model_.nodes[home].meshes;
        if (const json* instancing = extension(from, "EXT_mesh_gpu_instancing"))
            add_instances(*instancing, node, added);
        else
            meshes.insert(meshes.end(), added.begin(), added.end());
    }

    // Skinned meshes ignore their node's transform: a common node at the root holds them.
    uint32_t skin_home() {
        if (skin_home_ < 0) {
            skin_home_ = static_cast<int>(model_.nodes.size());
            model_.nodes.push_back({"skins", -1, glm::mat4(1), {}});
        }
        return static_cast<uint32_t>(skin_home_);
    }

    void set_deformation(const json& from, uint32_t node, Deformation& how) {
        how.node = node;
        if (const auto weights = from.find("weights"); weights != from.end())
            for (size_t i = 0; i < std::min(weights->size(), how.weights.size()); ++i)
                how.weights[i] = weights->at(i).get<float>();
        if (!from.contains("skin")) {
            how.joints.clear();
            how.joint_weights.clear();
            return;
        }
        how.skin = skin_of(from.at("skin").get<size_t>());
        const size_t joints = model_.skins[how.skin].joints.size();
        for (const glm::uvec4& j : how.joints)
            for (int k = 0; k < 4; ++k)
                if (j[k] >= joints) file_.refuse("joint {} of a skin with {}", j[k], joints);
    }

    uint32_t skin_of(size_t number) {
        const json& from = file_.entry("skins", number);
        ModelSkin skin;
        for (const json& joint : from.at("joints")) {
            const size_t node = joint.get<size_t>();
            if (node >= nodes_.size() || nodes_[node] < 0)
                file_.refuse("skin {} has joint {}, which is not in the scene", number, node);
            skin.joints.push_back(static_cast<uint32_t>(nodes_[node]));
        }
        skin.inverse_bind.assign(skin.joints.size(), glm::mat4(1));
        if (from.contains("inverseBindMatrices")) {
            const std::vector<float> m = file_.floats(from.at("inverseBindMatrices").get<size_t>(), 16);
            if (m.size() < 16 * skin.joints.size())
                file_.refuse("skin {} has {} matrices for {} joints", number, m.size() / 16, skin.joints.size());
            for (size_t i = 0; i < skin.joints.size(); ++i) skin.inverse_bind[i] = glm::make_mat4(&m[16 * i]);
        }
        model_.skins.push_back(std::move(skin));
        return static_cast<uint32_t>(model_.skins.size() - 1);
    }

    void add_instances(const json& from, uint32_t parent, const std::vector<uint32_t>& meshes) {
        const json& attributes = from.at("attributes");
        const auto read = [&](const char* key, size_t components) {
            return attributes.contains(key) ? file_.floats(attributes.at(key).get<size_t>(), components)
                                            : std::vector<float>();
        };
        const auto moved = read("TRANSLATION", 3), turned = read("ROTATION", 4), scaled = read("SCALE", 3);
        // Not in the extension; what exporters call it.
        const auto color = attributes.find("_COLOR_0");
        const size_t channels = color == attributes.end() ? 0 : file_.components(color->get<size_t>());
        const auto colors = channels == 3 || channels == 4 ? read("_COLOR_0", channels) : std::vector<float>();
        for (const auto& [key, value] : attributes.items())
            if (key != "TRANSLATION" && key != "ROTATION" && key != "SCALE" && (key != "_COLOR_0" || colors.empty()))
                leave_out(model_, "instances' " + key, "mesh");
        const size_t count = std::max({moved.size() / 3, turned.size() / 4, scaled.size() / 3});
        for (size_t i = 0; i < count; ++i) {
            glm::mat4 local(1);
            if (i < moved.size() / 3) local = glm::translate(local, glm::make_vec3(&moved[3 * i]));
            if (i < turned.size() / 4) local *= glm::mat4_cast(unit_rotation(glm::make_vec4(&turned[4 * i])));
            if (i < scaled.size() / 3) local = glm::scale(local, glm::make_vec3(&scaled[3 * i]));
            Node& node = model_.nodes.emplace_back(Node{"", static_cast<int>(parent), local, meshes});
            for (size_t c = 0; c < channels && (i + 1) * channels <= colors.size(); ++c)
                node.color[static_cast<int>(c)] = std::clamp(colors[i * channels + c], 0.0f, 1.0f);
        }
    }

    void add_camera(const json& from, uint32_t node) {
        if (value_or<std::string>(from, "type", "") != "perspective")
            return leave_out(model_, "orthographic cameras", "camera");
        const json& lens = from.at("perspective");
        FileCamera camera{node, {}, value_or<std::string>(from, "name", "")};
        camera.camera.fov_y_rad = std::clamp(lens.at("yfov").get<float>(), 0.01f, 3.1f);
        camera.camera.near_m = std::max(value_or(lens, "znear", 0.05f), 1e-5f);
        camera.camera.far_m = std::max(value_or(lens, "zfar", 1e9f), 2 * camera.camera.near_m);
        model_.cameras.push_back(camera);
    }

    // KHR_lights_punctual uses lux and candela; scene lights use the radiance of a white surface, smaller by pi.
    void add_light(size_t number, uint32_t node) {
        const json* all = extension(file_.root, "KHR_lights_punctual");
        if (!all || number >= all->at("lights").size()) file_.refuse("light {} is missing", number);
        const json& from = all->at("lights").at(number);
        Light light;
        const std::string type = from.at("type");
        if (type != "directional" && type != "spot" && type != "point")
            return leave_out(model_, fmt::format("lights of type '{}'", type), "light");
        light.kind = type == "directional" ? Light::Kind::directional
                     : type == "spot"      ? Light::Kind::spot
                                           : Light::Kind::point;
        light.color = glm::clamp(vector_or(from, "color", glm::vec3(1)), 0.0f, 1.0f);
        light.intensity = std::clamp(value_or(from, "intensity", 1.0f) / glm::pi<float>(), 0.0f, 1e6f);
        light.range_m = std::clamp(value_or(from, "range", 1e6f), 0.0f, 1e6f);
        light.softness = -1.0f / 0.65f;  // the power mix(1, 0.35, softness) of the cone's edge is 2; below 0: punctual
        if (const auto spot = from.find("spot"); spot != from.end()) {
            light.outer_rad =
                std::clamp(value_or(*spot, "outerConeAngle", glm::quarter_pi<float>()), 0.0f, glm::half_pi<float>());
            light.inner_rad = std::clamp(value_or(*spot, "innerConeAngle", 0.0f), 0.0f, light.outer_rad);
        }
        light.name = value_or<std::string>(from, "name", "");
        model_.lights.push_back({node, light});
    }

    GltfFile file_;
    Model model_;
    std::vector<int> nodes_;
    std::vector<bool> in_scene_;
    std::map<size_t, std::vector<uint32_t>> shared_;
    KnownPrimitives primitives_;
    int skin_home_ = -1;
};

}  // namespace

glm::quat unit_rotation(glm::vec4 q) {
    const glm::quat given(q.w, q.x, q.y, q.z);
    return std::abs(glm::dot(q, q) - 1.0f) < 1e-6f ? given : glm::normalize(given);
}

Model read_gltf(const std::filesystem::path& path) {
    try {
        return GltfReader(path).read();
    } catch (const json::parse_error& e) {
        throw InputError("{}: not JSON, at byte {}", path.string(), e.byte);
    } catch (const json::exception& e) {
        const std::string why = e.what();
        throw InputError("{}: not as glTF has it: {}", path.string(), why.substr(why.find("] ") + 2));
    }
}

}  // namespace lightwalk
