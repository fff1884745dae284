#include "18_playground/gltf.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/quaternion.hpp>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <span>

#include "18_playground/commands.h"
#include "18_playground/saving.h"
#include "common/base/error.h"
#include "common/base/files.h"
#include "common/base/own_files.h"
#include "common/image/decode.h"
#include "common/image/mip_levels.h"
#include "common/scene/image_pool.h"

namespace lightwalk {

namespace fs = std::filesystem;
namespace {

using json = nlohmann::ordered_json;

json list(const glm::vec3& v) { return {v.x, v.y, v.z}; }

constexpr int float_component = 5126, index_component = 5125, vertex_target = 34962, index_target = 34963;

struct GltfWriter {
    fs::path target;
    json out;
    std::string bytes;                      // of the buffer
    std::map<fs::path, std::string> files;  // images that are made here, beside the target
    std::set<std::string> extensions;

    // Appends to a list of the file. Returns the place.
    int push(const char* list, json value) {
        out[list].push_back(std::move(value));
        return static_cast<int>(out[list].size()) - 1;
    }

    // Bytes of the buffer as a view. `use`: the view's target, 0: none.
    int view(std::span<const std::byte> data, int use = 0) {
        while (bytes.size() % 4) bytes.push_back('\0');
        json own{{"buffer", 0}, {"byteOffset", bytes.size()}, {"byteLength", data.size()}};
        if (use) own["target"] = use;
        bytes.append(reinterpret_cast<const char*>(data.data()), data.size());
        return push("bufferViews", own);
    }
};

bool is_png(std::span<const std::byte> file) { return file.size() > 3 && file[1] == std::byte{'P'}; }
bool is_jpeg(std::span<const std::byte> file) { return file.size() > 3 && file[0] == std::byte{0xFF}; }

// glTF 2.0, 3.8.3: PNG or JPEG.
bool is_allowed(const TextureMap& map) {
    if (map.bytes) return is_png(*map.bytes) || is_jpeg(*map.bytes);
    const std::string ending = map.file.extension().string();
    static const std::set<std::string> allowed{".png", ".PNG", ".jpg", ".JPG", ".jpeg", ".JPEG"};
    return allowed.contains(ending);
}

// Characters other than letters, digits and -._~/ as %NN.
std::string escaped(const std::string& text) {
    std::string uri;
    for (const unsigned char c : text)
        uri += std::isalnum(c) || std::string_view("-._~/").find(char(c)) != std::string_view::npos
                   ? std::string(1, char(c))
                   : fmt::format("%{:02X}", c);
    return uri;
}

// Of a turn and a scale: columns sx (c, -s) and sy (s, c).
json transform_of(const MapPlace& place) {
    const float along = glm::length(place.turn[0]);
    return {{"offset", {place.offset.x, place.offset.y}},
            {"rotation", std::atan2(-place.turn[0].y, place.turn[0].x)},
            {"scale", {along, along > 0 ? glm::determinant(place.turn) / along : 1.0f}}};
}

// At the centre of a texel of an image of another size; between its own texels linear, and it repeats.
glm::vec4 sampled(const Image8& image, int x, int y, int width, int height) {
    const glm::vec2 at{(float(x) + 0.5f) * float(image.width) / float(width) - 0.5f,
                       (float(y) + 0.5f) * float(image.height) / float(height) - 0.5f};
    const glm::ivec2 low(glm::floor(at));
    const auto texel = [&](int right, int down) {
        return glm::vec4(
            image.at((low.x + right + image.width) % image.width, (low.y + down + image.height) % image.height));
    };
    const glm::vec2 part = at - glm::vec2(low);
    return glm::mix(glm::mix(texel(0, 0), texel(1, 0), part.x), glm::mix(texel(0, 1), texel(1, 1), part.x), part.y);
}

// A texture as a material uses it, in 8 bits. Throws InputError where it cannot be read.
Image8 picture_of(const TextureUse& use) {
    if (is_hdr_name(use.file())) return to_srgb8(read_image_linear(use.file()));
    const DecodedTexture texture = decode_texture(use);
    std::vector<std::byte> texels = texture.levels.at(0);
    if (texture.desc.format == VK_FORMAT_R16G16B16A16_SFLOAT) texels = srgb_codes(texels);
    Image8 picture(static_cast<int>(texture.desc.size.x), static_cast<int>(texture.desc.size.y));
    const size_t step = texels.size() / (4 * picture.pixels.size());  // of 16 bits the upper eight
    for (size_t i = 0; i < picture.pixels.size(); ++i)
        for (int c = 0; c < 4; ++c)
            picture.pixels[i][c] = std::to_integer<uint8_t>(texels[(4 * i + size_t(c)) * step + step - 1]);
    return picture;
}

// Colours with opacity in their alpha, the only place that glTF has for it: `color`'s own alpha times `opacity`'s red. As
// large as the larger of both in each direction.
Image8 color_with_opacity(const Image8& colors, const Image8& alphas) {
    Image8 both(std::max(colors.width, alphas.width), std::max(colors.height, alphas.height));
    for (int y = 0; y < both.height; ++y)
        for (int x = 0; x < both.width; ++x) {
            glm::vec4 texel = sampled(colors, x, y, both.width, both.height);
            texel.a *= sampled(alphas, x, y, both.width, both.height).r / 255.0f;
            both.at(x, y) = glm::u8vec4(glm::round(texel));
        }
    return both;
}

// Images that are PNG or JPEG files keep their names, or their bytes where a model's file has them; others are made.
class GltfTextures {
  public:
    explicit GltfTextures(GltfWriter& writer) : writer_(writer) {}

    // A textureInfo.
    json texture(const TextureUse& use) {
        json own{{"source", image(use)}};
        if (use.map.sampler != Sampler{}) own["sampler"] = sampler(use.map.sampler);
        const std::string key = own.dump();
        auto [known, is_new] = textures_.try_emplace(key, 0);
        if (is_new) known->second = writer_.push("textures", own);
        json info{{"index", known->second}};
        const MapPlace& place = use.map.place;
        if (place.set > 0) info["texCoord"] = place.set;
        if (place.turn == glm::mat2(1.0f) && place.offset == glm::vec2(0.0f)) return info;
        writer_.extensions.insert("KHR_texture_transform");
        info["extensions"]["KHR_texture_transform"] = transform_of(flipped(place));
        return info;
    }

    // The colours of `color`, white where there are none, with the opacity in their alpha.
    json texture(const std::optional<TextureUse>& color, const TextureUse& opacity) {
        fs::path& file = cutouts_[{color ? color->key() : "", opacity.key()}];
        if (file.empty()) {
            file = beside(fmt::format("cutout{}", cutouts_.size()));
            const Image8 colors = color ? picture_of(*color) : Image8(1, 1, glm::u8vec4(255));
            writer_.files[file] = encode_png(color_with_opacity(colors, picture_of(opacity)));
        }
        TextureMap map = color ? color->map : opacity.map;  // where it lies, and how it is sampled
        map.file = file;
        map.bytes = nullptr;
        map.image = -1;
        map.channel = 0;
        map.base_gain = {0, 1};
        return texture(TextureUse{.map = map});
    }

  private:
    int image(const TextureUse& use) {
        const std::string key = use.key();
        if (const auto known = images_.find(key); known != images_.end()) return known->second;
        const TextureMap& map = use.map;
        json own;
        if (use.as != TextureUse::As::stored || map.channel || map.base_gain != glm::vec2(0, 1) || !is_allowed(map)) {
            const fs::path file = beside(fmt::format("made{}", images_.size()));
            writer_.files[file] = encode_png(picture_of(use));
            own["uri"] = uri_of(file);
        } else if (map.bytes) {
            own["bufferView"] = writer_.view(*map.bytes);
            own["mimeType"] = is_png(*map.bytes) ? "image/png" : "image/jpeg";
        } else {
            own["uri"] = uri_of(map.file);
        }
        return images_[key] = writer_.push("images", own);
    }

    fs::path beside(const std::string& what) const {
        fs::path file = writer_.target;
        file.replace_filename(fmt::format("{}.{}.png", writer_.target.stem().string(), what));
        return file;
    }

    std::string uri_of(const fs::path& file) const {
        std::error_code error;
        const fs::path near = fs::relative(file, fs::absolute(writer_.target).parent_path(), error);
        return escaped((error || near.empty() ? file : near).generic_string());
    }

    int sampler(const Sampler& from) {
        const auto wrap = [](Wrap w) { return w == Wrap::clamp ? 33071 : w == Wrap::mirror ? 33648 : 10497; };
        const bool nearest = from.filter == Filter::nearest;
        json own{{"wrapS", wrap(from.wrap)},
                 {"wrapT", wrap(from.wrap_v.value_or(from.wrap))},
                 {"magFilter", nearest ? 9728 : 9729},
                 {"minFilter", from.max_lod == 0 ? (nearest ? 9728 : 9729)
                               : nearest         ? 9986
                                                 : 9987}};
        const std::string key = own.dump();
        const auto [known, is_new] = samplers_.try_emplace(key, 0);
        if (is_new) known->second = writer_.push("samplers", own);
        return known->second;
    }

    GltfWriter& writer_;
    std::map<std::string, int> images_, textures_, samplers_;
    std::map<std::pair<std::string, std::string>, fs::path> cutouts_;
};

class Exporter {
  public:
    Exporter(const Document& document, const Scene& scene, const fs::path& target)
        : document_(document), scene_(scene) {
        writer.target = target;
        for (uint32_t i = 0; i < scene.items.size(); ++i) items_[scene.items[i].object].push_back(i);
        const Exported all = exported(document);
        for (uint32_t i = 0; i < all.objects.size(); ++i) places_[all.objects[i]] = i;
    }

    json whole(const std::string& buffer_name) {
        json& out = writer.out;
        out["asset"] = {{"version", "2.0"}, {"generator", "Lightwalk chapter 18"}};
        for (const char* key :
             {"nodes", "meshes", "materials", "accessors", "bufferViews", "textures", "images", "samplers"})
            out[key] = json::array();
        json roots = json::array();
        for (const EntryId id : document_.at(root_entry).children)
            if (const int node = add(id); node >= 0) roots.push_back(node);
        roots.push_back(add_camera());
        if (scene_.file.ambient != glm::vec3(0.0f)) leave_out(left_out, "light from all sides");
        if (scene_.file.environment) leave_out(left_out, "environment");
        out["scene"] = 0;
        out["scenes"] = json::array({{{"nodes", roots}}});
        out["buffers"] = json::array({{{"uri", buffer_name}, {"byteLength", writer.bytes.size()}}});
        for (const char* key : {"meshes", "materials", "accessors", "bufferViews", "textures", "images", "samplers"})
            if (out[key].empty()) out.erase(key);
        if (writer.bytes.empty()) out.erase("buffers");
        if (!lights_.empty()) {
            writer.extensions.insert("KHR_lights_punctual");
            out["extensions"]["KHR_lights_punctual"]["lights"] = lights_;
        }
        if (!writer.extensions.empty()) out["extensionsUsed"] = writer.extensions;
        return out;
    }

    GltfWriter writer;
    Model left_out;  /// properties without a place in glTF

  private:
    template <class T>
    int accessor(const std::vector<T>& values, int component, const char* type, int target, json limits = {}) {
        json own{{"bufferView", writer.view(std::as_bytes(std::span(values)), target)},
                 {"componentType", component},
                 {"count", values.size()},
                 {"type", type}};
        own.update(limits.is_null() ? json::object() : limits);
        return writer.push("accessors", own);
    }

    // Whether textures cut holes into it: an opacity map, or the alpha of its colours.
    bool is_cut_out(const DrawItem& item) const {
        if (item.material.alpha_cutoff == 0.0f) return false;
        if (item.material.alpha_cutoff > 0.0f) return true;
        const auto& color = item.loaded_maps[MapSlot::diffuse];
        return item.maps[MapSlot::opacity] || (color && scene_.images()->has_alpha(*color));
    }

    // A slot's texture: the scene file's, or the model's.
    static std::optional<TextureUse> use_of(const DrawItem& item, const SceneObject& object, MapSlot slot) {
        if (!item.loaded_maps[slot]) return {};
        const MapSlotInfo& info = map_slots()[static_cast<size_t>(slot)];
        const auto given = object.material.maps.find(info.name);
        if (given == object.material.maps.end()) return texture_use(own_material(item), slot);
        return TextureUse{.map = {.file = find_asset(given->second)}, .kind = info.kind};
    }

    // As in chapter 14: the scene's numbers, the model's, or values from the exponent, 2 / alpha² - 2 with alpha the
    // square of roughness (Karis, 2013).
    static glm::vec2 metalness_and_roughness(const DrawItem& item) {
        const MaterialNumbers& m = item.material;
        const bool stated = m.metallic_roughness || m.microfacets || m.roughness != Material{}.roughness;
        const float exponent = std::pow(2.0f / (m.shininess + 2.0f), 0.25f);
        return {item.metalness >= 0 ? item.metalness : m.metalness, item.roughness >= 0 ? item.roughness
                                                                    : stated            ? m.roughness
                                                                                        : exponent};
    }

    json emission(const MaterialNumbers& m, json& extensions) {
        const glm::vec3 emitted = scene_.file.emission * m.emissive;
        const float strength = std::max({emitted.r, emitted.g, emitted.b});
        if (!(strength > 1.0f)) return list(emitted);
        writer.extensions.insert("KHR_materials_emissive_strength");
        extensions["KHR_materials_emissive_strength"]["emissiveStrength"] = strength;
        return list(emitted / strength);
    }

    // KHR_materials_transmission: the base colour filters what passes, and over a thickness of 1 the attenuation colour.
    // The metal's share of a material passes nothing.
    void add_glass(const MaterialNumbers& m, const glm::vec3& base, float metalness, json& extensions) {
        const float passes = 1.0f - m.opacity, most = 1.0f - metalness;
        if (passes > most) leave_out(left_out, "transmission of a metal", "material");
        writer.extensions.insert("KHR_materials_transmission");
        extensions["KHR_materials_transmission"]["transmissionFactor"] = std::min(passes / most, 1.0f);
        if (base == m.transmission) return;
        const glm::vec3 rest = glm::clamp(m.transmission / glm::max(base, 1e-6f), 0.0f, 1.0f);
        if (glm::any(glm::greaterThan(m.transmission, base + 1e-6f)))
            leave_out(left_out, "transmission above the base colour", "material");
        writer.extensions.insert("KHR_materials_volume");
        extensions["KHR_materials_volume"] = {
            {"thicknessFactor", 1.0f}, {"attenuationDistance", 1.0f}, {"attenuationColor", list(rest)}};
    }

    int material(const DrawItem& item, const SceneObject& object) {
        const MaterialNumbers& m = item.material;
        json own{{"name", clean_name(m.name)}};
        const auto set = [&](json& into, const char* key, MapSlot slot) {
            if (const auto use = use_of(item, object, slot)) into[key] = textures_.texture(*use);
            return into.contains(key);
        };
        own["pbrMetallicRoughness"] = json::object();  // its place: what is inserted later moves it
        json pbr;
        // Numbers of the object replace those of its orm map, which glTF multiplies: both do without the texture.
        const glm::vec2 numbers = metalness_and_roughness(item);
        const bool by_orm = bool(item.loaded_maps[MapSlot::orm]), is_plain = item.metalness >= 0 && item.roughness >= 0;
        if (!by_orm || !is_plain)
            set(pbr, "metallicRoughnessTexture", by_orm ? MapSlot::orm : MapSlot::metallic_roughness);
        if (by_orm) set(own, "occlusionTexture", MapSlot::orm);
        if (by_orm && !is_plain && (item.metalness > 0 || item.roughness >= 0))
            leave_out(left_out, "one number in place of a map", "material");
        const bool has_texture = pbr.contains("metallicRoughnessTexture");
        pbr["metallicFactor"] = by_orm && item.metalness < 0 ? 1.0f : numbers.x;
        pbr["roughnessFactor"] = by_orm && item.roughness < 0 ? 1.0f : numbers.y;
        const float metalness = has_texture ? 0.0f : numbers.x;  // where a texture says what is metal, glass is not
        const bool is_tinted = item.transparent && m.transmission.r >= 0.0f, is_glass = is_tinted && metalness < 1.0f;
        if (is_tinted && !is_glass) leave_out(left_out, "transmission of a metal", "material");
        // Glass without a body has the tint as its base colour; another's tint is absorbed on the way through it.
        const glm::vec3 base = is_glass && m.opacity == 0.0f ? m.transmission : m.diffuse;
        pbr["baseColorFactor"] = {base.x, base.y, base.z, is_glass ? 1.0f : m.opacity};
        const auto color = use_of(item, object, MapSlot::diffuse), opacity = use_of(item, object, MapSlot::opacity);
        if (opacity)
            pbr["baseColorTexture"] = textures_.texture(color, *opacity);
        else if (color)
            pbr["baseColorTexture"] = textures_.texture(*color);
        own["pbrMetallicRoughness"] = pbr;
        if (set(own, "normalTexture", MapSlot::normal)) own["normalTexture"]["scale"] = m.normal_scale;
        if (!by_orm && set(own, "occlusionTexture", MapSlot::occlusion))
            own["occlusionTexture"]["strength"] = m.occlusion_strength;
        set(own, "emissiveTexture", MapSlot::emissive);
        json extensions = json::object();
        own["emissiveFactor"] = emission(m, extensions);
        if (is_glass) add_glass(m, base, metalness, extensions);
        if (m.unlit) {
            extensions["KHR_materials_unlit"] = json::object();
            writer.extensions.insert("KHR_materials_unlit");
        }
        if (!extensions.empty()) own["extensions"] = extensions;
        if (item.two_sided) own["doubleSided"] = true;
        own["alphaMode"] = is_glass ? "OPAQUE" : item.transparent ? "BLEND" : is_cut_out(item) ? "MASK" : "OPAQUE";
        const auto& knobs = document_.settings().knobs;
        const auto cutoff = knobs.find("maps.cutoff");
        if (own["alphaMode"] == "MASK" && (m.alpha_cutoff > 0 || cutoff != knobs.end()))
            own["alphaCutoff"] = m.alpha_cutoff > 0 ? m.alpha_cutoff : std::stof(cutoff->second);
        const std::string key = own.dump();
        if (const auto known = materials_.find(key); known != materials_.end()) return known->second;
        name_left_out(item);
        return materials_[key] = writer.push("materials", own);
    }

    void name_left_out(const DrawItem& item) {
        const MaterialNumbers& m = item.material;
        if (m.specular != glm::vec3(0.0f) && !m.metallic_roughness) leave_out(left_out, "specular colours", "material");
        for (const MapSlot slot :
             {MapSlot::specular, MapSlot::height, MapSlot::gloss, MapSlot::detail_normal, MapSlot::displacement})
            if (item.loaded_maps[slot]) leave_out(left_out, map_slots()[size_t(slot)].name + " maps", "material");
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
                positions.push_back(v.position);
                normals.push_back(v.normal);
                uvs.push_back({v.uv.x, 1.0f - v.uv.y});  // glTF's v runs from the top
                box.add(v.position);
            }
            vertices->second = {{"POSITION", accessor(positions, float_component, "VEC3", vertex_target,
                                                      {{"min", list(box.lower)}, {"max", list(box.upper)}})},
                                {"NORMAL", accessor(normals, float_component, "VEC3", vertex_target)},
                                {"TEXCOORD_0", accessor(uvs, float_component, "VEC2", vertex_target)}};
            std::vector<glm::vec2> second;
            for (const glm::vec2 uv : mesh.second_uvs) second.push_back({uv.x, 1.0f - uv.y});
            if (!second.empty())
                vertices->second["TEXCOORD_1"] = accessor(second, float_component, "VEC2", vertex_target);
            if (!mesh.colors.empty())
                vertices->second["COLOR_0"] = accessor(mesh.colors, float_component, "VEC4", vertex_target);
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

    // An object's node with those of its model's nodes that contain meshes, then its children.
    int add(EntryId id) {
        const Entry& entry = document_.at(id);
        if (entry.hidden) return -1;
        if (entry.light()) return add_light(*entry.light());
        if (is_terrain(entry)) {
            leave_out(left_out, "terrain");
            return -1;
        }
        const SceneObject& object = *entry.object();
        const glm::quat q(rotation_of(object.rotation_deg));
        json node{{"name", clean_name(object.name)},
                  {"translation", list(object.position)},
                  {"rotation", {q.x, q.y, q.z, q.w}},
                  {"scale", list(object.scale)}};
        if (object.motion) leave_out(left_out, "motions", "object");
        json children = json::array();
        std::map<uint32_t, json> by_node;
        for (const uint32_t i : items_[places_.at(id)])
            by_node[scene_.items[i].node].push_back(primitive(scene_.items[i], object));
        for (const auto& [of_node, primitives] : by_node) {
            const GpuModel& model = *scene_.items[items_[places_.at(id)].front()].model;
            if (!model.model.motions.empty() && of_node == by_node.begin()->first)
                leave_out(left_out, "animations", "object");
            const int mesh = writer.push("meshes", {{"primitives", primitives}});
            const std::string name = clean_name(model.model.nodes[of_node].name);
            children.push_back(
                writer.push("nodes", {{"name", name}, {"matrix", matrix(model.nodes[of_node])}, {"mesh", mesh}}));
        }
        for (const EntryId child : entry.children)
            if (const int below = add(child); below >= 0) children.push_back(below);
        if (!children.empty()) node["children"] = children;
        return writer.push("nodes", node);
    }

    // Lights and cameras look along -z.
    static glm::quat along(const glm::vec3& direction, const glm::vec3& up = {0, 1, 0}) {
        const glm::vec3 d = glm::normalize(direction);
        const bool across = glm::length(glm::cross(d, glm::normalize(up))) > 0.1f;
        return glm::quatLookAt(d, across ? up : std::fabs(d.x) < 0.9f ? glm::vec3(1, 0, 0) : glm::vec3(0, 0, 1));
    }

    int add_light(const Light& light) {
        static constexpr const char* kinds[] = {"directional", "point", "spot"};
        json own{{"name", clean_name(light.name)},
                 {"type", kinds[static_cast<int>(light.kind)]},
                 {"color", list(light.color)},
                 {"intensity", glm::pi<float>() * light.intensity}};  // lux, candela; ours is the radiance of white
        if (light.kind != Light::Kind::directional && light.range_m > 0) own["range"] = light.range_m;
        if (light.kind == Light::Kind::spot)
            own["spot"] = {{"innerConeAngle", std::min(light.inner_rad, 0.999f * std::min(light.outer_rad, 1.5707f))},
                           {"outerConeAngle", std::clamp(light.outer_rad, 1e-3f, 1.5707f)}};
        lights_.push_back(own);
        const glm::quat q = along(light.direction);
        return writer.push(
            "nodes", {{"name", light.name.empty() ? fmt::format("light {}", lights_.size()) : clean_name(light.name)},
                      {"translation", list(light.position)},
                      {"rotation", {q.x, q.y, q.z, q.w}},
                      {"extensions", {{"KHR_lights_punctual", {{"light", lights_.size() - 1}}}}}});
    }

    int add_camera() {
        const Camera& camera = document_.settings().camera;
        json lens{{"yfov", camera.fov_y_rad}, {"znear", camera.near_m}};
        if (std::isfinite(camera.far_m)) lens["zfar"] = camera.far_m;
        writer.out["cameras"] = json::array({{{"type", "perspective"}, {"perspective", lens}}});
        const glm::quat q = along(camera.target - camera.position, camera.up);
        return writer.push("nodes", {{"name", "camera"},
                                     {"translation", list(camera.position)},
                                     {"rotation", {q.x, q.y, q.z, q.w}},
                                     {"camera", 0}});
    }

    const Document& document_;
    const Scene& scene_;
    json lights_ = json::array();
    GltfTextures textures_{writer};
    std::map<uint32_t, std::vector<uint32_t>> items_;
    std::unordered_map<EntryId, uint32_t> places_;
    std::map<std::string, int> materials_;
    std::map<const Mesh*, json> vertices_;
    std::map<const Part*, int> indices_;
};

}  // namespace

std::string export_gltf(const Document& document, const Scene& scene, const fs::path& file) {
    const fs::path target = file.extension() == ".gltf" ? file : fs::path(file.string() + ".gltf");
    fs::path buffer = target;
    buffer.replace_extension(".bin");
    for (const SceneObject& object : scene.file.objects)
        if (std::error_code error;
            !object.model.empty() && !object.hidden && fs::equivalent(target, find_asset(object.model), error))
            throw InputError("{}: the scene shows this file; save the scene under another name first", target.string());
    check_writable(target);
    Exporter exporter(document, scene, target);
    GltfWriter& writer = exporter.writer;
    writer.files[target] = exporter.whole(clean_name(buffer.filename().string())).dump(1, '\t') + "\n";
    if (!writer.bytes.empty()) writer.files[buffer] = std::move(writer.bytes);
    write_files(writer.files);
    return left_out_text(exporter.left_out);
}

}  // namespace lightwalk
