#include "common/scene/scene.h"

#include <glm/gtc/constants.hpp>
#include <numeric>
#include <tuple>
#include <unordered_map>

#include "common/base/error.h"
#include "common/scene/bare.h"

namespace lightwalk {
namespace {

std::vector<MapPlacement> placements_of(const std::vector<DrawItem>& items) {
    std::vector<MapPlacement> placements(1);
    const auto is_placed = [](const DrawItem& item) { return item.maps.are_placed(); };
    if (std::none_of(items.begin(), items.end(), is_placed)) return placements;
    placements.clear();
    for (const DrawItem& item : items)
        for (const MapPlace& place : item.maps.places) placements.push_back({place.turn, place.offset, place.set});
    return placements;
}

void check_roles(const SceneObject& object, const Model& model) {
    std::set<std::string> names;
    for (const Material& material : model.materials) names.insert(material.name);
    const auto list = [](const std::set<std::string>& words) {
        std::string text;
        for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
        return text;
    };
    for (const auto& [name, role] : object.role.materials)
        if (!names.contains(name))
            throw InputError("{} names '{}', which is no material of {}; it has {}", object.role.where, name,
                             object.model.string(), list(names));
}

std::vector<uint32_t> places(size_t from, size_t to) {
    std::vector<uint32_t> result(to - from);
    std::iota(result.begin(), result.end(), static_cast<uint32_t>(from));
    return result;
}

}  // namespace

void Scene::load(Gpu& gpu, SceneFile scene, const ModelLoader& loader) {
    white_ = images(gpu).constant(glm::vec4(1.0f));
    flat_ = images_->constant({0.5f, 0.5f, 1.0f, 1.0f});
    file = std::move(scene);
    time_s_ = 0;
    sky_sun_.reset();
    load_environment();
    items.clear();
    moving_models_.clear();
    deforming_.clear();
    link_objects();
    const Roles roles(file);
    for (size_t i = 0; i < file.objects.size(); ++i)
        if (!file.objects[i].model.empty() && !objects_[i].hidden) add_items(gpu, i, roles, loader);
    place_and_upload(gpu);
}

ImagePool& Scene::images(Gpu& gpu) {
    if (!images_) images_ = std::make_unique<ImagePool>(gpu);
    return *images_;
}

void Scene::link_objects() {
    objects_.clear();
    std::unordered_map<std::string_view, int> by_name;
    for (size_t i = 0; i < file.objects.size(); ++i) {
        const SceneObject& object = file.objects[i];
        Placed& placed_object = objects_.emplace_back();
        if (!object.parent.empty()) placed_object.parent = by_name.at(object.parent);
        const Placed root;
        const Placed& parent = placed_object.parent < 0 ? root : objects_[static_cast<size_t>(placed_object.parent)];
        placed_object.local = local_transform(object, time_s_);
        placed_object.world = parent.world * placed_object.local;
        placed_object.moves = object.motion || parent.moves;
        placed_object.hidden = object.hidden || parent.hidden;
        if (!object.name.empty()) by_name[object.name] = static_cast<int>(i);
    }
}

void Scene::place_and_upload(Gpu& gpu) {
    for (DrawItem& item : items) place(item);
    sort_items();
    find_batches();
    epoch = Epoch::next();
    bounds = {};
    moving_items_.clear();
    std::vector<Instance> instance_data;
    std::vector<MaterialData> numbers;
    for (size_t i = 0; i < items.size(); ++i) {
        const DrawItem& item = items[i];
        bounds.add(item.bounds);
        instance_data.push_back(instance_of(item, i));
        numbers.push_back(material_data(item, file.emission));
        if (objects_[item.object].moves || item.model->model.motions.size())
            moving_items_.push_back(static_cast<uint32_t>(i));
    }
    to_upload_.assign(items.size(), false);
    instances = gpu.upload("instances", instance_data);
    materials = gpu.upload("materials", numbers);
    to_paint_ = to_upload_;
    placements = gpu.upload("placements", placements_of(items));
    first_item_.clear();
}

void Scene::add_items(Gpu& gpu, size_t object, const Roles& roles, const ModelLoader& loader) {
    const SceneObject& from = file.objects[object];
    const std::filesystem::path model_file = find_asset(from.model);
    auto gpu_model = models_.load(gpu, model_file, loader);
    if (from.ground)
        gpu_model = models_.load(gpu, model_file.string() + ", ground", [above = gpu_model](const auto& ground) {
            return ground_below(above->model, ground.string());
        });
    const Model& model = gpu_model->model;
    check_roles(from, model);
    if (!model.motions.empty() &&
        std::find(moving_models_.begin(), moving_models_.end(), gpu_model) == moving_models_.end()) {
        pose_model(*gpu_model, 0.0f);
        moving_models_.push_back(gpu_model);
        if (std::any_of(model.meshes.begin(), model.meshes.end(), [](const Mesh& m) { return bool(m.deformation); })) {
            deforming_.insert(gpu_model.get());
            to_deform_ = true;
        }
    }
    for (uint32_t node = 0; node < model.nodes.size(); ++node)
        for (const uint32_t mesh : model.nodes[node].meshes)
            for (uint32_t part = 0; part < model.meshes[mesh].parts.size(); ++part) {
                DrawItem& item = items.emplace_back();
                item.model = gpu_model;
                item.mesh = mesh;
                item.part = part;
                item.node = node;
                item.object = static_cast<uint32_t>(object);
                const Material& own = own_material(item);
                item.role = roles.of(object, own.name);
                item.maps = load_maps(*images_, own, from.material, warned_);
                item.loaded_maps = item.maps;
                set_material(item, from.material, file.bare);
            }
}

// Groups equal items by first occurrence, opaque before transparent.
void Scene::sort_items() {
    using Images = std::array<const Image*, map_slot_count>;
    using Key = std::tuple<bool, const GpuModel*, uint32_t, uint32_t, bool, Images>;
    std::map<Key, size_t> groups;
    std::vector<size_t> group;
    group.reserve(items.size());
    for (const DrawItem& item : items) {
        Images images;
        for (size_t i = 0; i < map_slot_count; ++i) images[i] = item.maps[i].get();
        const Key key{item.transparent, item.model.get(), item.mesh, item.part, item.mirrored, images};
        group.push_back(groups.emplace(key, groups.size()).first->second);
    }
    std::vector<uint32_t> order = places(0, items.size());
    std::stable_sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) {
        return std::pair(items[a].transparent, group[a]) < std::pair(items[b].transparent, group[b]);
    });
    if (!std::is_sorted(order.begin(), order.end())) {
        std::vector<DrawItem> sorted;
        sorted.reserve(items.size());
        for (const uint32_t i : order) sorted.push_back(std::move(items[i]));
        items = std::move(sorted);
    }
    first_transparent_ = static_cast<size_t>(
        std::count_if(items.begin(), items.end(), [](const DrawItem& item) { return !item.transparent; }));
}

void Scene::load_environment() {
    environment = nullptr;
    if (!file.environment) return;
    const auto refuse = [&](const std::string& why) { throw InputError("{}: {}", file.environment.where, why); };
    try {
        environment = images_->load(find_asset(file.environment.image), TextureKind::data, 3);
    } catch (const InputError& e) { refuse(e.what()); }
    const glm::uvec2 size = environment->desc.size;
    if (size.x != 2 * size.y)
        refuse(fmt::format("{} is {}x{}, expected an image of all directions, twice as wide as high",
                           file.environment.image.string(), size.x, size.y));
}

DrawList Scene::all() const { return {*this, places(0, items.size())}; }

Sun Scene::sun() const {
    if (sky_sun_) return *sky_sun_;
    const auto directional = [](const Light& light) { return light.kind == Light::Kind::directional; };
    const auto found = std::find_if(file.lights.begin(), file.lights.end(), directional);
    if (found == file.lights.end()) return {.sky = file.ambient};
    return {-glm::normalize(found->direction), found->intensity * found->color, file.ambient};
}

static void put_sun(const Sun& sun, std::vector<Light>& lights) {
    const auto directional = [](const Light& light) { return light.kind == Light::Kind::directional; };
    auto found = std::find_if(lights.begin(), lights.end(), directional);
    if (found == lights.end()) found = lights.insert(lights.begin(), Light{.shadow = true});
    // Light intensities are radiances of a facing white surface.
    found->direction = -sun.to_sun;
    found->color = sun.light;
    found->intensity = 1.0f / glm::pi<float>();
}

const LightList& Scene::lights() const {
    std::vector<Light> all = file.lights;
    if (sky_sun_) put_sun(*sky_sun_, all);
    if (!lights_ || *lights_ != all) lights_ = std::make_shared<const std::vector<Light>>(std::move(all));
    return lights_;
}

DrawList Scene::opaque() const { return {*this, places(0, first_transparent_)}; }
DrawList Scene::transparent() const { return {*this, places(first_transparent_, items.size())}; }

const Image& Scene::texture(const DrawItem& item, MapSlot slot) const {
    if (const auto& map = item.maps[slot]) return *map;
    return map_slots()[static_cast<size_t>(slot)].is_normal ? *flat_ : *white_;
}

size_t Scene::triangle_count() const {
    size_t count = 0;
    for (const DrawItem& item : items) count += item.model->model.meshes[item.mesh].parts[item.part].index_count / 3;
    return count;
}

void Scene::clear() {
    items.clear();
    moving_items_.clear();
    environment = nullptr;
    models_.clear();
    if (images_) images_->clear();
    warned_.clear();
}

}  // namespace lightwalk
