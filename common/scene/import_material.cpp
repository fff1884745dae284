// Materials of Assimp scenes.
#include <assimp/GltfMaterial.h>

#include <cmath>

#include "common/base/text.h"
#include "common/scene/asset_path.h"
#include "common/scene/import_parts.h"
#include "common/scene/model_bytes.h"

namespace lightwalk {
namespace {
namespace fs = std::filesystem;

class ImportedMaterials {
  public:
    ImportedMaterials(const aiScene& scene, const fs::path& path, Model& model)
        : scene_(scene), path_(path), model_(model) {}

    Material read(const aiMaterial& from) {
        Material to;
        to.name = from.GetName().C_Str();
        const auto color = [&](const char* key, unsigned type, unsigned index, glm::vec3& value) {
            aiColor3D c;
            if (from.Get(key, type, index, c) == AI_SUCCESS) value = {c.r, c.g, c.b};
        };
        color(AI_MATKEY_COLOR_AMBIENT, to.ambient);
        color(AI_MATKEY_COLOR_DIFFUSE, to.diffuse);
        color(AI_MATKEY_BASE_COLOR, to.diffuse);
        color(AI_MATKEY_COLOR_SPECULAR, to.specular);
        color(AI_MATKEY_COLOR_EMISSIVE, to.emissive);
        from.Get(AI_MATKEY_SHININESS, to.shininess);
        from.Get(AI_MATKEY_OPACITY, to.opacity);
        from.Get(AI_MATKEY_REFRACTI, to.refraction);
        const bool rough = from.Get(AI_MATKEY_ROUGHNESS_FACTOR, to.roughness) == AI_SUCCESS;
        const bool metal = from.Get(AI_MATKEY_METALLIC_FACTOR, to.metalness) == AI_SUCCESS;
        to.metallic_roughness = to.microfacets = rough && metal;
        if (to.name == AI_DEFAULT_MATERIAL_NAME) to.diffuse = Material{}.diffuse;
        int number = 0;
        if (from.Get(AI_MATKEY_TWOSIDED, number) == AI_SUCCESS && number) to.sides = Sides::both;
        int shading = aiShadingMode_Phong;
        from.Get(AI_MATKEY_SHADING_MODEL, shading);
        to.unlit = shading == aiShadingMode_NoShading;
        // Assimp assigns a grey specular colour to Collada's <lambert>.
        if (path_.extension() == ".dae" && shading == aiShadingMode_Gouraud) to.specular = glm::vec3(0);
        if (float reflectivity = 0; from.Get(AI_MATKEY_REFLECTIVITY, reflectivity) == AI_SUCCESS && reflectivity > 0)
            leave_out(model_, "reflection", "material");
        for (const auto& [type, map] : maps)
            if (!(to.*map)) to.*map = texture(from, type);
        for (const aiTextureType type : {aiTextureType_LIGHTMAP, aiTextureType_REFLECTION, aiTextureType_TRANSMISSION,
                                         aiTextureType_CLEARCOAT, aiTextureType_SHEEN})
            if (from.GetTextureCount(type) > 0)
                leave_out(model_, std::string("texture of ") + aiTextureTypeToString(type), "material");
        // Exporters disagree on which end of the transparency range is opaque.
        if (to.opacity <= 0.0f && !to.opacity_map) {
            to.opacity = 1;
            warn("{}: material '{}': opacity 0 would make it vanish; drawn opaque", path_.string(), to.name);
        }
        return to;
    }

  private:
    static constexpr std::pair<aiTextureType, TextureMap Material::*> maps[] = {
        {aiTextureType_DIFFUSE, &Material::diffuse_map},
        {aiTextureType_BASE_COLOR, &Material::diffuse_map},
        {aiTextureType_SPECULAR, &Material::specular_map},
        {aiTextureType_AMBIENT, &Material::ambient_map},
        {aiTextureType_AMBIENT_OCCLUSION, &Material::occlusion_map},
        {aiTextureType_EMISSIVE, &Material::emissive_map},
        {aiTextureType_EMISSION_COLOR, &Material::emissive_map},
        {aiTextureType_SHININESS, &Material::shininess_map},
        {aiTextureType_OPACITY, &Material::opacity_map},
        {aiTextureType_HEIGHT, &Material::bump_map},
        {aiTextureType_NORMALS, &Material::normal_map},
        {aiTextureType_NORMAL_CAMERA, &Material::normal_map},
        {aiTextureType_DISPLACEMENT, &Material::displacement_map},
        {aiTextureType_METALNESS, &Material::metalness_map},
        {aiTextureType_DIFFUSE_ROUGHNESS, &Material::roughness_map}};

    static Wrap wrap_of(const aiMaterial& from, aiTextureType type, const char* key) {
        int mode = aiTextureMapMode_Wrap;
        from.Get(key, type, 0, mode);
        return mode == aiTextureMapMode_Clamp || mode == aiTextureMapMode_Decal ? Wrap::clamp
               : mode == aiTextureMapMode_Mirror                                ? Wrap::mirror
                                                                                : Wrap::repeat;
    }

    TextureMap texture(const aiMaterial& from, aiTextureType type) {
        aiString file;
        if (from.GetTexture(type, 0, &file) != AI_SUCCESS || file.length == 0) return {};
        TextureMap map;
        map.sampler.wrap = wrap_of(from, type, _AI_MATKEY_MAPPINGMODE_U_BASE);
        const Wrap v = wrap_of(from, type, _AI_MATKEY_MAPPINGMODE_V_BASE);
        if (v != map.sampler.wrap) map.sampler.wrap_v = v;
        aiUVTransform transform;
        if (from.Get(_AI_MATKEY_UVTRANSFORM_BASE, type, 0, transform) == AI_SUCCESS) {
            const float c = std::cos(transform.mRotation), s = std::sin(transform.mRotation);
            map.place.turn = glm::mat2(c, s, -s, c) * glm::mat2(transform.mScaling.x, 0, 0, transform.mScaling.y);
            map.place.offset = {transform.mTranslation.x, transform.mTranslation.y};
        }
        int set = 0;
        from.Get(_AI_MATKEY_UVWSRC_BASE, type, 0, set);
        map.place.set = set == 1 ? 1 : 0;
        if (const aiTexture* inside = scene_.GetEmbeddedTexture(file.C_Str())) {
            map.file = path_.string() + ", image " + file.C_Str();
            if (inside->mHeight != 0) {
                leave_out(model_, "uncompressed images inside the file", "texture");
                return {};
            }
            map.image = image(*inside);
        } else {
            const bool is_uri = path_.extension() == ".dae";
            map.file = resolve_file(is_uri ? decode_uri(file.C_Str()) : file.C_Str(), path_.parent_path());
        }
        return map;
    }

    // Embedded image file: mWidth is its size in bytes.
    int image(const aiTexture& inside) {
        const auto [known, is_new] = images_.try_emplace(&inside, static_cast<int>(model_.images.size()));
        if (is_new) {
            const auto* bytes = reinterpret_cast<const std::byte*>(inside.pcData);
            model_.images.push_back(std::make_shared<const std::vector<std::byte>>(bytes, bytes + inside.mWidth));
        }
        return known->second;
    }

    const aiScene& scene_;
    const fs::path& path_;
    Model& model_;
    std::map<const aiTexture*, int> images_;
};

}  // namespace

void add_import_materials(const aiScene& scene, const fs::path& path, Model& model) {
    ImportedMaterials materials(scene, path, model);
    for (unsigned i = 0; i < scene.mNumMaterials; ++i) {
        model.materials.push_back(materials.read(*scene.mMaterials[i]));
        limit_numbers(model.materials.back(), path.string());
    }
    if (model.materials.empty()) model.materials.emplace_back();
}

}  // namespace lightwalk
