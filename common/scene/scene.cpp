#include "common/scene/scene.h"

#include <cstdio>

#include "common/base/error.h"

namespace lightwalk {
namespace {

struct Slot {
    const char* name;
    uint32_t bit;
    TextureKind kind;
    int channels;  ///< that a texture must have at least
    const TextureMap Material::*map;
};

// In the order of the bits in common/structs.h. What MTL has no statement for, only a scene file can name.
constexpr Slot slots[] = {
    {"diffuse", DIFFUSE_MAP, TextureKind::color, 1, &Material::diffuse_map},
    {"specular", SPECULAR_MAP, TextureKind::data, 1, &Material::specular_map},
    {"emissive", EMISSIVE_MAP, TextureKind::color, 1, &Material::emissive_map},
    {"opacity", OPACITY_MAP, TextureKind::data, 1, &Material::opacity_map},
    {"normal", NORMAL_MAP, TextureKind::data, 3, &Material::normal_map},
    {"height", HEIGHT_MAP, TextureKind::data, 1, &Material::displacement_map},
    {"orm", ORM_MAP, TextureKind::data, 3, nullptr},
    {"occlusion", OCCLUSION_MAP, TextureKind::data, 1, nullptr},
    {"gloss", GLOSS_MAP, TextureKind::data, 1, &Material::shininess_map},
    {"detail_normal", DETAIL_NORMAL_MAP, TextureKind::data, 3, nullptr},
};

Material overridden(Material material, const MaterialOverride& with) {
    if (with.diffuse) material.diffuse = *with.diffuse;
    if (with.specular) material.specular = *with.specular;
    if (with.emissive) material.emissive = *with.emissive;
    if (with.shininess) material.shininess = *with.shininess;
    if (with.opacity) material.opacity = *with.opacity;
    return material;
}

const Slot& find_slot(const std::string& name) {
    std::string known;
    for (const Slot& slot : slots) {
        if (slot.name == name) return slot;
        known += (known.empty() ? "" : ", ") + std::string(slot.name);
    }
    throw InputError("unknown texture slot '" + name + "'; there are: " + known);
}

}  // namespace

std::shared_ptr<GpuModel> ModelPool::load(Gpu& gpu, const std::filesystem::path& file, const ModelLoader& loader) {
    std::error_code error;
    std::shared_ptr<GpuModel>& entry = models_[std::filesystem::weakly_canonical(file, error).string()];
    if (entry) return entry;
    auto model = std::make_shared<GpuModel>();
    model->model = loader(file);
    for (const Mesh& mesh : model->model.meshes) {
        model->vertices.push_back(gpu.upload(mesh.name + " vertices", mesh.vertices));
        model->indices.push_back(gpu.upload(mesh.name + " indices", mesh.indices));
    }
    return entry = model;
}

void Scene::load(Gpu& gpu, SceneFile scene, const ModelLoader& loader) {
    if (!images_) images_ = std::make_unique<ImagePool>(gpu);
    white_ = images_->constant(glm::vec4(1.0f));
    flat_ = images_->constant({0.5f, 0.5f, 1.0f, 1.0f});
    file = std::move(scene);
    items.clear();
    bounds = {};
    std::map<std::string, glm::mat4> world;
    for (const SceneObject& object : file.objects) {
        const glm::mat4 parent = object.parent.empty() ? glm::mat4(1.0f) : world.at(object.parent);
        const glm::mat4 transform = parent * local_transform(object);
        if (!object.name.empty()) world[object.name] = transform;
        if (!object.model.empty()) place(gpu, object, transform, loader);
    }
    std::vector<Instance> instance_data;
    std::vector<MaterialData> material_data;
    for (const DrawItem& item : items) {
        bounds.add(item.bounds);
        instance_data.push_back({item.transform, glm::transpose(glm::inverse(glm::mat3(item.transform))),
                                 static_cast<uint32_t>(material_data.size())});
        MaterialData data{.diffuse = item.material.diffuse,
                          .shininess = item.material.shininess,
                          .specular = item.material.specular,
                          .opacity = item.material.opacity,
                          .emissive = item.material.emissive,
                          .maps = 0,
                          .roughness = item.roughness,
                          .metalness = item.metalness};
        for (const Slot& slot : slots)
            if (item.maps.count(std::string(slot.name) + "_map")) data.maps |= slot.bit;
        material_data.push_back(data);
    }
    instances = gpu.upload("instances", instance_data);
    materials = gpu.upload("materials", material_data);
}

void Scene::place(Gpu& gpu, const SceneObject& object, const glm::mat4& world, const ModelLoader& loader) {
    const auto model = models_.load(gpu, find_asset(object.model), loader);
    const auto transforms = world_transforms(model->model);
    for (size_t node = 0; node < model->model.nodes.size(); ++node)
        for (const uint32_t mesh_index : model->model.nodes[node].meshes) {
            const Mesh& mesh = model->model.meshes[mesh_index];
            for (uint32_t part = 0; part < mesh.parts.size(); ++part) {
                DrawItem item{.model = model, .mesh = mesh_index, .part = part};
                item.transform = world * transforms[node];
                for (int corner = 0; corner < 8; ++corner) {
                    const glm::vec3 pick(corner & 1, corner >> 1 & 1, corner >> 2 & 1);
                    const glm::vec3 p = glm::mix(mesh.bounds.lower, mesh.bounds.upper, pick);
                    item.bounds.add(glm::vec3(item.transform * glm::vec4(p, 1.0f)));
                }
                const Material& own = model->model.materials[mesh.parts[part].material];
                item.material = overridden(own, object.material);
                item.roughness = object.material.roughness.value_or(-1.0f);
                item.metalness = object.material.metalness.value_or(-1.0f);
                const auto load_map = [&](const std::filesystem::path& image, const Slot& slot) {
                    try {
                        return images_->load(image, slot.kind, slot.channels);
                    } catch (const InputError& e) { throw InputError(std::string(slot.name) + " map: " + e.what()); }
                };
                for (const Slot& slot : slots) {
                    if (!slot.map || !(own.*slot.map)) continue;
                    try {
                        item.maps[std::string(slot.name) + "_map"] = load_map((own.*slot.map).file, slot);
                    } catch (const InputError& e) {
                        if (warned_.insert(own.name + "\n" + e.what()).second)
                            std::fprintf(stderr, "warning: material '%s': %s; drawn without it\n", own.name.c_str(),
                                         e.what());
                    }
                }
                for (const auto& [name, texture] : object.material.maps)
                    item.maps[name + "_map"] = load_map(find_asset(texture), find_slot(name));
                items.push_back(std::move(item));
            }
        }
}

void Scene::draw(Raster& pass) const {
    for (const DrawItem& item : items) draw(pass, item);
}

void Scene::bind(Raster& pass, const DrawItem& item) const {
    if (pass.wants("instances")) pass.set("instances", instances);
    if (pass.wants("materials")) pass.set("materials", materials);
    if (pass.wants("vertices")) pass.set("vertices", item.model->vertices[item.mesh]);
    for (const auto& [name, buffers] : item.model->attributes)
        if (pass.wants(name)) pass.set(name, buffers[item.mesh]);
    for (const Slot& slot : slots) {
        const std::string binding = std::string(slot.name) + "_map";
        if (!pass.wants(binding)) continue;
        const auto map = item.maps.find(binding);
        const bool is_normal = slot.bit == NORMAL_MAP || slot.bit == DETAIL_NORMAL_MAP;
        pass.set(binding, map != item.maps.end() ? *map->second : is_normal ? *flat_ : *white_);
    }
}

void Scene::draw(Raster& pass, const DrawItem& item) const {
    bind(pass, item);
    const Part& part = item.model->model.meshes[item.mesh].parts[item.part];
    pass.draw_indexed(item.model->indices[item.mesh], part.first_index, part.index_count, 1,
                      static_cast<uint32_t>(&item - items.data()));
}

size_t Scene::triangle_count() const {
    size_t count = 0;
    for (const DrawItem& item : items) count += item.model->model.meshes[item.mesh].parts[item.part].index_count / 3;
    return count;
}

void Scene::clear() {
    items.clear();
    models_.clear();
    if (images_) images_->clear();
    warned_.clear();
}

SceneFile scene_of_model(const std::filesystem::path& model, const Bounds& bounds) {
    SceneFile scene;
    scene.file = model;
    scene.objects.push_back({.name = model.stem().string(), .parent = {}, .model = model, .material = {}});
    const glm::vec3 center = bounds.empty() ? glm::vec3(0.0f) : bounds.center();
    const float radius = bounds.empty() ? 1.0f : std::max(0.5f * glm::length(bounds.extent()), 1e-4f);
    Camera& camera = scene.camera;
    camera.fov_y_rad = glm::radians(35.0f);
    camera.target = center;
    camera.position =
        center + glm::normalize(glm::vec3(0.55f, 0.3f, 1.0f)) * radius / std::sin(0.5f * camera.fov_y_rad);
    camera.near_m = radius * 0.02f;
    camera.far_m = radius * 100.0f;
    scene.lights = {{.color = {1.0f, 0.96f, 0.9f}, .direction = glm::normalize(glm::vec3(-0.6f, -0.9f, -0.7f))},
                    {.color = {0.6f, 0.75f, 1.0f}, .direction = glm::normalize(glm::vec3(0.8f, -0.2f, -0.3f))}};
    scene.lights[0].intensity = 2.2f;
    scene.lights[1].intensity = 0.7f;
    scene.ambient = glm::vec3(0.06f, 0.07f, 0.09f);
    scene.background = glm::vec3(0.035f, 0.045f, 0.06f);
    return scene;
}

}  // namespace lightwalk
