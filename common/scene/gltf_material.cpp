// glTF materials: metallic-roughness, specular-glossiness, unlit, textures.
#include "common/scene/asset_path.h"
#include "common/scene/gltf_parts.h"

namespace lightwalk {
namespace {
using nlohmann::json;

MapPlace place_of(const json& info, size_t& set) {
    MapPlace place;
    set = value_or<size_t>(info, "texCoord", 0);
    const json* transform = extension(info, "KHR_texture_transform");
    if (!transform) return place;
    set = value_or<size_t>(*transform, "texCoord", set);
    const float angle = value_or(*transform, "rotation", 0.0f), c = std::cos(angle), s = std::sin(angle);
    const glm::vec2 scale = vector_or(*transform, "scale", glm::vec2(1));
    place.offset = vector_or(*transform, "offset", glm::vec2(0));
    place.turn = glm::mat2(c, -s, s, c) * glm::mat2(scale.x, 0, 0, scale.y);
    return flipped(place);
}

Wrap wrap_of(const json& sampler, const char* key) {
    const int code = value_or(sampler, key, 10497);
    return code == 33071 ? Wrap::clamp : code == 33648 ? Wrap::mirror : Wrap::repeat;
}

Sampler sampler_of(const json& from) {
    Sampler sampler;
    sampler.wrap = wrap_of(from, "wrapS");
    if (const Wrap v = wrap_of(from, "wrapT"); v != sampler.wrap) sampler.wrap_v = v;
    const int smaller = value_or(from, "minFilter", 9987), larger = value_or(from, "magFilter", 9729);
    if (larger == 9728) sampler.filter = Filter::nearest;
    if (smaller == 9984 || smaller == 9985) sampler.mip_filter = Filter::nearest;
    if (smaller == 9728 || smaller == 9729) sampler.max_lod = 0;
    return sampler;
}

class GltfMaterials {
  public:
    GltfMaterials(const GltfFile& file, Model& model) : file_(file), model_(model) {}

    Material read(const json& from) {
        Material m;
        m.name = value_or<std::string>(from, "name", "");
        m.metallic_roughness = m.microfacets = true;
        const json none = json::object();
        const json& pbr = from.contains("pbrMetallicRoughness") ? from.at("pbrMetallicRoughness") : none;
        glm::vec4 base = vector_or(pbr, "baseColorFactor", glm::vec4(1));
        m.diffuse_map = map(pbr, "baseColorTexture");
        m.metalness = value_or(pbr, "metallicFactor", 1.0f);
        m.roughness = value_or(pbr, "roughnessFactor", 1.0f);
        m.metallic_roughness_map = map(pbr, "metallicRoughnessTexture");
        m.diffuse = glm::vec3(base);
        if (const json* glossy = extension(from, "KHR_materials_pbrSpecularGlossiness"))
            base.a = read_glossy(*glossy, m);
        m.opacity = base.a;
        m.normal_map = map(from, "normalTexture");
        if (m.normal_map) m.normal_scale = value_or(from.at("normalTexture"), "scale", 1.0f);
        m.occlusion_map = map(from, "occlusionTexture");
        if (m.occlusion_map) m.occlusion_strength = value_or(from.at("occlusionTexture"), "strength", 1.0f);
        m.emissive_map = map(from, "emissiveTexture");
        m.emissive = vector_or(from, "emissiveFactor", glm::vec3(0));
        if (const json* strength = extension(from, "KHR_materials_emissive_strength"))
            m.emissive *= value_or(*strength, "emissiveStrength", 1.0f);
        m.unlit = extension(from, "KHR_materials_unlit") != nullptr;
        m.sides = value_or(from, "doubleSided", false) ? Sides::both : Sides::front;
        read_alpha(from, m);
        if (const json* glass = extension(from, "KHR_materials_transmission")) read_glass(from, *glass, m);
        if (!m.metallic_roughness) {  // roughness to Blinn–Phong exponent, as in chapter 04
            const float alpha = m.roughness * m.roughness;
            m.shininess = std::clamp(2.0f / std::max(alpha * alpha, 1e-8f) - 2.0f, 0.0f, 8192.0f);
        }
        return m;
    }

  private:
    // KHR_materials_transmission as a thin sheet: of the share `through` that passes into it, the base colour passes on, and
    // of KHR_materials_volume, for a straight path, the attenuation colour to the power of thickness / distance.
    void read_glass(const json& from, const json& glass, Material& m) {
        // Where a texture says what is metal, nothing there is: metals transmit no light.
        const float metalness = m.metallic_roughness_map ? 0.0f : m.metalness;
        const float through = value_or(glass, "transmissionFactor", 0.0f) * (1 - metalness);
        if (value_or(glass, "transmissionFactor", 0.0f) > 0) m.illumination = 4;  // MTL's number of glass
        if (glass.contains("transmissionTexture"))
            leave_out(model_, "KHR_materials_transmission's texture", "material");
        if (!(through > 0)) return;
        if (m.alpha_cutoff > 0) return leave_out(model_, "KHR_materials_transmission beside holes", "material");
        if (m.diffuse_map) leave_out(model_, "KHR_materials_transmission's tint by a base colour texture", "material");
        if (m.metallic_roughness_map && m.metalness > 0)
            leave_out(model_, "KHR_materials_transmission's metal by a texture", "material");
        glm::vec3 tint = m.diffuse;
        if (const json* volume = extension(from, "KHR_materials_volume")) {
            const float thickness = value_or(*volume, "thicknessFactor", 0.0f);
            const float distance = value_or(*volume, "attenuationDistance", INFINITY);
            if (thickness > 0) leave_out(model_, "KHR_materials_volume's refraction", "material");
            if (thickness > 0 && distance > 0)
                tint *= glm::pow(vector_or(*volume, "attenuationColor", glm::vec3(1)), glm::vec3(thickness / distance));
        }
        // Alpha is coverage: the uncovered share passes as it is.
        const float covered = m.opacity, passed = 1 - covered + covered * through;
        m.transmission = (1 - covered + covered * through * tint) / passed;
        m.opacity = 1 - passed;
        m.blend = true;
    }

    static void read_alpha(const json& from, Material& m) {
        const std::string mode = value_or<std::string>(from, "alphaMode", "OPAQUE");
        m.blend = mode == "BLEND";
        m.alpha_cutoff = mode == "MASK" ? value_or(from, "alphaCutoff", 0.5f) : 0.0f;
        if (mode == "OPAQUE") m.opacity = 1;
    }

    // KHR_materials_pbrSpecularGlossiness: roughness = 1 - specular texture's alpha. Returns the opacity.
    float read_glossy(const json& from, Material& m) {
        m.metallic_roughness = false;
        const glm::vec4 diffuse = vector_or(from, "diffuseFactor", glm::vec4(1));
        m.diffuse = glm::vec3(diffuse);
        m.diffuse_map = map(from, "diffuseTexture");
        m.specular = vector_or(from, "specularFactor", glm::vec3(1));
        m.specular_map = map(from, "specularGlossinessTexture");
        m.specular_map.is_color = true;
        m.metalness = 0;
        m.roughness = 1 - value_or(from, "glossinessFactor", 1.0f);
        m.metallic_roughness_map = {};
        if (m.specular_map) {
            m.roughness_map = m.specular_map;
            m.roughness_map.is_color = false;
            m.roughness_map.channel = 'm';
            m.roughness_map.base_gain = {1, -value_or(from, "glossinessFactor", 1.0f)};
            m.roughness = 1;
        }
        return diffuse.a;
    }

    TextureMap map(const json& from, const char* key) {
        const auto info = from.find(key);
        if (info == from.end()) return {};
        const json& texture = file_.entry("textures", info->at("index").get<size_t>());
        const json* const webp = extension(texture, "EXT_texture_webp");
        const json& named = webp && webp->contains("source") ? *webp : texture;
        const auto source = named.find("source");
        if (source == named.end()) return {};  // from an extension, reported separately
        TextureMap map = image(source->get<size_t>());
        size_t set = 0;
        map.place = place_of(*info, set);
        if (set > 1) {
            leave_out(model_, fmt::format("texture coordinates {}", set), "texture");
            set = 0;
        }
        map.place.set = static_cast<uint32_t>(set);
        if (const auto sampler = texture.find("sampler"); sampler != texture.end())
            map.sampler = sampler_of(file_.entry("samplers", sampler->get<size_t>()));
        return map;
    }

    TextureMap image(size_t index) {
        if (const auto known = images_.find(index); known != images_.end()) return known->second;
        const json& from = file_.entry("images", index);
        const auto uri = from.find("uri");
        TextureMap map;
        if (uri != from.end() && !uri->get<std::string>().starts_with("data:")) {
            map.file = resolve_uri(uri->get<std::string>(), file_.path.parent_path());
        } else {
            const std::string name = value_or<std::string>(from, "name", "");
            map.file = file_.path.string() + fmt::format(", image {}{}{}", index, name.empty() ? "" : " ", name);
            const std::string bytes = uri != from.end() ? file_.read_uri(uri->get<std::string>())
                                                        : std::string(file_.view(from.at("bufferView").get<size_t>()));
            const auto as_bytes = std::as_bytes(std::span(bytes));
            map.image = static_cast<int>(model_.images.size());
            model_.images.push_back(std::make_shared<const std::vector<std::byte>>(as_bytes.begin(), as_bytes.end()));
        }
        return images_[index] = map;
    }

    const GltfFile& file_;
    Model& model_;
    std::map<size_t, TextureMap> images_;
};

}  // namespace

// f ∘ transform ∘ f with f(u, v) = (u, 1 - v).
MapPlace flipped(const MapPlace& given) {
    const glm::mat2 flip(1, 0, 0, -1);
    const glm::vec2 one(0, 1);
    MapPlace place = given;
    place.turn = flip * given.turn * flip;
    place.offset = flip * (given.turn * one + given.offset) + one;
    return place;
}

void read_gltf_materials(const GltfFile& file, Model& model) {
    GltfMaterials materials(file, model);
    for (size_t i = 0; i < file.count("materials"); ++i)
        model.materials.push_back(materials.read(file.entry("materials", i)));
    model.materials.push_back(materials.read(json::object()));
}

}  // namespace lightwalk
