#include "18_playground/gltf.h"

#include <glm/gtc/quaternion.hpp>
#include <nlohmann/json.hpp>

#include "18_playground/commands.h"
#include "18_playground/gltf_textures.h"
#include "18_playground/saving.h"
#include "common/base/error.h"
#include "common/base/files.h"
#include "common/base/write_files.h"
#include "common/image/encode.h"

namespace lightwalk {
namespace fs = std::filesystem;
namespace {

using json = nlohmann::ordered_json;

json list(const glm::vec3& v) { return {v.x, v.y, v.z}; }

constexpr int float_component = 5126, index_component = 5125, vertex_target = 34962, index_target = 34963;

class Exporter {
  public:
    Exporter(const Document& document, const Scene& scene, const fs::path& target)
        : document_(document), scene_(scene), folder_(fs::absolute(target).parent_path()), target_(target) {
        for (uint32_t i = 0; i < scene.items.size(); ++i) items_[scene.items[i].object].push_back(i);
        const Exported all = exported(document);
        for (uint32_t i = 0; i < all.objects.size(); ++i) places_[all.objects[i]] = i;
    }

    json whole(const std::string& buffer_name) {
        out_["asset"] = {{"version", "2.0"}, {"generator", "Lightwalk chapter 18"}};
        for (const char* key : {"nodes", "meshes", "materials", "accessors", "bufferViews", "textures", "images"})
            out_[key] = json::array();
        json roots = json::array();
        for (const EntryId id : document_.at(root_entry).children)
            if (const int node = add(id); node >= 0) roots.push_back(node);
        roots.push_back(add_camera());
        out_["scene"] = 0;
        out_["scenes"] = json::array({{{"nodes", roots}}});
        out_["buffers"] = json::array({{{"uri", buffer_name}, {"byteLength", bytes.size()}}});
        for (const char* key : {"meshes", "materials", "accessors", "bufferViews", "textures", "images"})
            if (out_[key].empty()) out_.erase(key);
        if (bytes.empty()) out_.erase("buffers");
        if (!lights_.empty()) {
            out_["extensionsUsed"] = {"KHR_lights_punctual"};
            out_["extensions"]["KHR_lights_punctual"]["lights"] = lights_;
        }
        return out_;
    }
    std::string bytes;                      ///< of the buffer
    std::map<fs::path, std::string> files;  ///< textures that are made here, beside the target

  private:
    int push(const char* key, json value) {
        out_[key].push_back(std::move(value));
        return static_cast<int>(out_[key].size()) - 1;
    }

    template <class T>
    int accessor(const std::vector<T>& values, int component, const char* type, int target, json limits = {}) {
        while (bytes.size() % 4) bytes.push_back('\0');
        const json view{
            {"buffer", 0}, {"byteOffset", bytes.size()}, {"byteLength", values.size() * sizeof(T)}, {"target", target}};
        bytes.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
        json own{{"bufferView", push("bufferViews", view)},
                 {"componentType", component},
                 {"count", values.size()},
                 {"type", type}};
        own.update(limits.is_null() ? json::object() : limits);
        return push("accessors", own);
    }

    int texture(const fs::path& file) {
        const std::string key = file.string();
        if (const auto known = textures_.find(key); known != textures_.end()) return known->second;
        std::error_code error;
        const fs::path near = fs::relative(file, folder_, error);
        const int image = push("images", {{"uri", escaped((error || near.empty() ? file : near).generic_string())}});
        return textures_[key] = push("textures", {{"source", image}});
    }

    // The colours of `color` with the alpha of `opacity`, in a file of its own.
    fs::path with_opacity(const fs::path& color, const fs::path& opacity) {
        fs::path& file = cutouts_[{color, opacity}];
        if (!file.empty()) return file;
        file = target_;
        file.replace_filename(fmt::format("{}.cutout{}.png", target_.stem().string(), cutouts_.size()));
        files[file] = encode_png(color_with_opacity(color, opacity));
        return file;
    }

    // Whether textures cut holes into it: an opacity map, or the alpha of its colours.
    bool is_cut_out(const DrawItem& item) const {
        const auto& color = item.loaded_maps[MapSlot::diffuse];
        return item.maps[MapSlot::opacity] || (color && scene_.images()->has_alpha(*color));
    }

    // A URI: what is no letter, digit or -._~/ as %NN.
    static std::string escaped(const std::string& text) {
        std::string uri;
        for (const unsigned char c : text)
            uri += std::isalnum(c) || std::string_view("-._~/").find(char(c)) != std::string_view::npos
                       ? std::string(1, char(c))
                       : fmt::format("%{:02X}", c);
        return uri;
    }

    int material(const DrawItem& item, const SceneObject& object) {
        const Material& m = item.material;
        json own{{"name", clean_name(m.name)}};
        const auto file_of = [&](const char* slot, const fs::path& model_file) -> fs::path {
            const auto given = object.material.maps.find(slot);
            return given == object.material.maps.end() ? model_file : find_asset(given->second);
        };
        json& pbr = own["pbrMetallicRoughness"];
        pbr["baseColorFactor"] = {m.diffuse.x, m.diffuse.y, m.diffuse.z, m.opacity};
        // Without a number of its own, roughness from the exponent (Karis, 2013: the exponent is 2 / alpha² - 2).
        const float roughness = item.roughness >= 0 ? item.roughness : std::pow(2.0f / (m.shininess + 2.0f), 0.25f);
        pbr["roughnessFactor"] = item.maps[MapSlot::orm] ? 1.0f : roughness;
        pbr["metallicFactor"] = item.maps[MapSlot::orm] ? 1.0f : std::max(item.metalness, 0.0f);
        const auto set = [&](json& into, const char* key, const char* slot, const fs::path& model_file) {
            if (const fs::path file = file_of(slot, model_file); !file.empty()) into[key] = {{"index", texture(file)}};
        };
        const fs::path color = file_of("diffuse", m.diffuse_map.file);
        if (item.maps[MapSlot::opacity])
            pbr["baseColorTexture"] = {{"index", texture(with_opacity(color, file_of("opacity", m.opacity_map.file)))}};
        else if (!color.empty())
            pbr["baseColorTexture"] = {{"index", texture(color)}};
        set(pbr, "metallicRoughnessTexture", "orm", item.maps[MapSlot::orm] ? m.roughness_map.file : "");
        set(own, "normalTexture", "normal", m.normal_map.file);
        set(own, "occlusionTexture", "occlusion", "");
        set(own, "emissiveTexture", "emissive", m.emissive_map.file);
        own["emissiveFactor"] = list(glm::min(
            own.contains("emissiveTexture") ? glm::max(m.emissive, glm::vec3(1.0f)) : m.emissive, glm::vec3(1.0f)));
        own["alphaMode"] = item.transparent ? "BLEND" : is_cut_out(item) ? "MASK" : "OPAQUE";
        const auto& knobs = document_.settings().knobs;
        if (const auto cutoff = knobs.find("maps.cutoff"); cutoff != knobs.end() && own["alphaMode"] == "MASK")
            own["alphaCutoff"] = std::stof(cutoff->second);
        const std::string key = own.dump();
        if (const auto known = materials_.find(key); known != materials_.end()) return known->second;
        return materials_[key] = push("materials", own);
    }

    // Vertices of a mesh, once; indices of a part, once.
    json primitive(const DrawItem& item, const SceneObject& object) {
        const Mesh& mesh = item.model->model.meshes[item.mesh];
        auto [vertices, added] = vertices_.try_emplace(&mesh);
        if (added) {
            std::vector<glm::vec3> positions, normals;
            std::vector<glm::vec2> uvs;
            Bounds box;
            for (const Vertex& v : mesh.vertices) {
                positions.push_back(v.position), normals.push_back(v.normal);
                uvs.push_back({v.uv.x, 1.0f - v.uv.y});  // glTF's v runs from the top
                box.add(v.position);
            }
            vertices->second = {{"POSITION", accessor(positions, float_component, "VEC3", vertex_target,
                                                      {{"min", list(box.lower)}, {"max", list(box.upper)}})},
                                {"NORMAL", accessor(normals, float_component, "VEC3", vertex_target)},
                                {"TEXCOORD_0", accessor(uvs, float_component, "VEC2", vertex_target)}};
        }
        const Part& part = mesh.parts[item.part];
        auto [indices, new_indices] = indices_.try_emplace(&part, 0);
        if (new_indices) {
            const auto begin = mesh.indices.begin() + part.first_index;
            indices->second = accessor(std::vector<uint32_t>(begin, begin + part.index_count), index_component,
                                       "SCALAR", index_target);
        }
        return {{"attributes", vertices->second}, {"indices", indices->second}, {"material", material(item, object)}};
    }

    static json matrix(const glm::mat4& m) {
        json all = json::array();
        for (int c = 0; c < 4; ++c)
            for (int r = 0; r < 4; ++r) all.push_back(m[c][r]);
        return all;
    }

    // An object's node with those of its model's nodes that have meshes below it, then its children.
    int add(EntryId id) {
        const Entry& entry = document_.at(id);
        if (entry.hidden) return -1;
        if (entry.light()) return add_light(*entry.light());
        const SceneObject& object = *entry.object();
        const glm::quat q(rotation_of(object.rotation_deg));
        json node{{"name", clean_name(object.name)},
                  {"translation", list(object.position)},
                  {"rotation", {q.x, q.y, q.z, q.w}},
                  {"scale", list(object.scale)}};
        json children = json::array();
        std::map<uint32_t, json> by_node;
        for (const uint32_t i : items_[places_.at(id)])
            by_node[scene_.items[i].node].push_back(primitive(scene_.items[i], object));
        for (const auto& [of_node, primitives] : by_node) {
            const GpuModel& model = *scene_.items[items_[places_.at(id)].front()].model;
            const int mesh = push("meshes", {{"primitives", primitives}});
            const std::string name = clean_name(model.model.nodes[of_node].name);
            children.push_back(
                push("nodes", {{"name", name}, {"matrix", matrix(model.nodes[of_node])}, {"mesh", mesh}}));
        }
        for (const EntryId child : entry.children)
            if (const int below = add(child); below >= 0) children.push_back(below);
        if (!children.empty()) node["children"] = children;
        return push("nodes", node);
    }

    // Lights and cameras look along -z.
    static glm::quat along(const glm::vec3& direction) {
        const glm::vec3 d = glm::normalize(direction);
        return glm::quatLookAt(d, std::fabs(d.y) < 0.99f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0));
    }

    int add_light(const Light& light) {
        static constexpr const char* kinds[] = {"directional", "point", "spot"};
        json own{{"name", clean_name(light.name)},
                 {"type", kinds[static_cast<int>(light.kind)]},
                 {"color", list(light.color)},
                 {"intensity", light.intensity}};
        if (light.kind != Light::Kind::directional && light.range_m > 0) own["range"] = light.range_m;
        if (light.kind == Light::Kind::spot)
            own["spot"] = {{"innerConeAngle", std::min(light.inner_rad, 0.999f * std::min(light.outer_rad, 1.5707f))},
                           {"outerConeAngle", std::clamp(light.outer_rad, 1e-3f, 1.5707f)}};
        lights_.push_back(own);
        const glm::quat q = along(light.direction);
        return push("nodes",
                    {{"name", light.name.empty() ? fmt::format("light {}", lights_.size()) : clean_name(light.name)},
                     {"translation", list(light.position)},
                     {"rotation", {q.x, q.y, q.z, q.w}},
                     {"extensions", {{"KHR_lights_punctual", {{"light", lights_.size() - 1}}}}}});
    }

    int add_camera() {
        const Camera& camera = document_.settings().camera;
        json lens{{"yfov", camera.fov_y_rad}, {"znear", camera.near_m}};
        if (std::isfinite(camera.far_m)) lens["zfar"] = camera.far_m;
        out_["cameras"] = json::array({{{"type", "perspective"}, {"perspective", lens}}});
        const glm::quat q = along(camera.target - camera.position);
        return push("nodes", {{"name", "camera"},
                              {"translation", list(camera.position)},
                              {"rotation", {q.x, q.y, q.z, q.w}},
                              {"camera", 0}});
    }

    const Document& document_;
    const Scene& scene_;
    const fs::path folder_, target_;
    json out_, lights_ = json::array();
    std::map<uint32_t, std::vector<uint32_t>> items_;
    std::unordered_map<EntryId, uint32_t> places_;
    std::map<std::string, int> textures_, materials_;
    std::map<std::pair<fs::path, fs::path>, fs::path> cutouts_;
    std::map<const Mesh*, json> vertices_;
    std::map<const Part*, int> indices_;
};

}  // namespace

void export_gltf(const Document& document, const Scene& scene, const fs::path& file) {
    const fs::path target = file.extension() == ".gltf" ? file : fs::path(file.string() + ".gltf");
    fs::path buffer = target;
    buffer.replace_extension(".bin");
    for (const SceneObject& object : scene.file.objects)
        if (std::error_code error;
            !object.model.empty() && !object.hidden && fs::equivalent(target, find_asset(object.model), error))
            throw InputError("{}: the scene shows this file; save the scene under another name first", target.string());
    check_writable(target);
    Exporter exporter(document, scene, target);
    exporter.files[target] = exporter.whole(clean_name(buffer.filename().string())).dump(1, '\t') + "\n";
    if (!exporter.bytes.empty()) exporter.files[buffer] = std::move(exporter.bytes);
    write_files(exporter.files);
}

}  // namespace lightwalk
