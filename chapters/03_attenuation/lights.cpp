#include "03_attenuation/lights.h"

#include <fmt/core.h>

#include <cmath>

#include "03_attenuation/exercises.h"

namespace lightwalk {

Lights::Lights(Module& owner, std::string name) : Module(owner, std::move(name), "lights") {}

void Lights::update(Frame& frame, const Scene& scene, const LightList& lights) {
    buffer_.update(frame, lights);
    update_objects(frame, scene);
}

void Lights::update(Frame& frame, const Scene& scene, const std::vector<Light>& lights) {
    buffer_.update(frame, lights);
    update_objects(frame, scene);
}

void Lights::update_objects(Frame& frame, const Scene& scene) {
    if (method.is("per_object")) object_lights_.update(frame, scene, buffer_, ends_at());
}

void Lights::set_cells(Frame& frame, const Scene& scene, const View& view) {
    grid.set_view(view, scene.bounds, method.is("tiled") ? LightGrid::Cells::tiles : LightGrid::Cells::clusters, slices,
                  buffer_.lights().size(), ends_at());
    if (has_cells()) grid.reserve_masks(frame.gpu.device);
}

void Lights::record(Frame& frame, const Scene& scene, const View& view, const ImageView& depth) {
    set_cells(frame, scene, view);
    if (has_cells()) grid.record(frame, *this, depth);
}

std::vector<std::string> Lights::status() const {
    if (!buffer_.rebuilds) return {};
    return {fmt::format("{} lights, packed {}×", buffer_.lights().size(), buffer_.rebuilds)};
}

std::vector<Resource> Lights::reads() const {
    std::vector<Resource> reads{buffer_.buffer};
    if (has_cells() && grid.masks) reads.insert(reads.end(), {grid.masks, grid.groups});
    return reads;
}

void Lights::bind(Pass& pass) const {
    pass.set_if_present("lights_data", buffer_.buffer);
    pass.set_if_present("lights_grid", grid.view);
    if (method.is("per_object")) {
        pass.set_if_present("lights_object_ends", object_lights_.ends);
        pass.set_if_present("lights_of_objects", object_lights_.lights);
    }
    if (has_cells()) {
        pass.set_if_present("lights_masks", grid.masks);
        pass.set_if_present("lights_groups", grid.groups);
    }
}

LightData pack(const Light& light) {
    return {.position = light.position,
            .range = light.range_m,
            .direction = light.direction,
            .kind = light.kind == Light::Kind::directional ? LIGHT_DIRECTIONAL
                    : light.kind == Light::Kind::point     ? LIGHT_POINT
                                                           : LIGHT_SPOT,
            .radiance = light.color * light.intensity,
            .softness = light.softness,
            .cos_inner = std::cos(light.inner_rad),
            .cos_outer = std::cos(light.outer_rad),
            .radius = light.kind == Light::Kind::directional ? std::tan(0.5f * light.size_rad) : 0.5f * light.size_m,
            .half_tube = 0.5f * light.tube_m};
}

// [update]
bool LightBuffer::update(Frame& frame, const LightList& lights) {
    if (buffer && (lights == lights_ || *lights == *lights_)) return false;
    lights_ = lights;
    std::vector<LightData> packed;
    packed.reserve(lights->size());
    for (const Light& light : *lights) packed.push_back(pack(light));
    frame.upload("lights", buffer, packed);
    ++rebuilds;
    return true;
}
// [/update]

bool LightBuffer::update(Frame& frame, const std::vector<Light>& lights) {
    if (buffer && lights == *lights_) return false;
    return update(frame, std::make_shared<const std::vector<Light>>(lights));
}

namespace {

void reserve(Device& device, Buffer& buffer, const char* name, VkDeviceSize words) {
    if (!buffer || buffer.bytes < 4 * words) buffer = Buffer(device, {.name = name, .bytes = 4 * words});
}

}  // namespace

glm::vec2 cluster_depths(const Camera& camera, const Bounds& scene) {
    const glm::vec3 forward = glm::normalize(camera.target - camera.position);
    float nearest = camera.far_m, farthest = camera.near_m;
    for (int corner = 0; corner < 8 && !scene.empty(); ++corner) {
        const glm::vec3 pick(corner & 1, corner >> 1 & 1, corner >> 2 & 1);
        const float depth = glm::dot(glm::mix(scene.lower, scene.upper, pick) - camera.position, forward);
        nearest = std::min(nearest, depth);
        farthest = std::max(farthest, depth);
    }
    farthest = std::max(std::min(farthest, camera.far_m), 1.01f * camera.near_m);
    return {std::clamp(nearest, std::max(camera.near_m, farthest / 500.0f), farthest / 1.01f), farthest};
}

void LightGrid::set_view(const View& seen, const Bounds& scene, Cells cells, int slices, size_t lights,
                         float threshold) {
    const Camera& camera = seen.camera;
    cells_ = cells;
    lights_ = lights;
    const glm::vec3 forward = glm::normalize(camera.target - camera.position);
    const glm::vec3 right = glm::normalize(glm::cross(forward, camera.up));
    const glm::vec2 depths = cluster_depths(camera, scene), whole(seen.crop.whole);
    const float tan_half = std::tan(0.5f * camera.fov_y_rad);
    view = {.eye = camera.position,
            .right = right,
            .up = glm::cross(right, forward),
            .forward = forward,
            .tan_half = {tan_half * whole.x / whole.y, tan_half},
            .inverse_near = 1.0f / camera.near_m,
            .inverse_far = 1.0f / camera.far_m,
            .size = seen.size,
            .whole = whole,
            .origin = glm::vec2(seen.crop.origin) + seen.crop.shift,
            .tile_px = cells == Cells::tiles ? tile_px : cluster_px,
            .slices = cells == Cells::tiles ? 1u : static_cast<uint32_t>(slices),
            .first_m = depths.x,
            .threshold = threshold};
    view.slices_per_log = static_cast<float>(view.slices) / std::log(depths.y / depths.x);

    const auto divide = [&] { view.tiles = (seen.size + view.tile_px - 1u) / view.tile_px; };
    constexpr VkDeviceSize most_bytes = 1u << 27;  // guaranteed by Vulkan (maxStorageBufferRange)
    for (divide(); view.tiles.x * view.tiles.y > 1 && 4 * mask_words() > most_bytes; divide()) view.tile_px *= 2;
}

void LightGrid::reserve_masks(Device& device) {
    reserve(device, masks, "light masks", mask_words());
    reserve(device, groups, "light groups", VkDeviceSize(group_count()) * cell_count());
}

void LightGrid::record(Frame& frame, const PassInputs& lights, const ImageView& depth) {
    if (cells_ == Cells::tiles)
        frame.compute("cull_tiles", {.reads = {depth}, .writes = {masks, groups}, .with = {lights}},
                      [&](Compute& pass) {
                          pass.use(cull_tiles).set("depth", depth, nearest_clamp).dispatch({view.tiles, 1});
                      });
    else if (group_count() > 0)
        frame.compute("cull_lights", {.writes = {masks, groups}, .with = {lights}}, [&](Compute& pass) {
            pass.use(cull_clusters).dispatch_threads(glm::uvec2(cell_count(), group_count()));
        });
}

void ObjectLights::update(Frame& frame, const Scene& scene, const LightBuffer& buffer, float threshold) {
    if (made_.is_current(buffer.rebuilds, scene.epoch, threshold, Exercises::epoch())) return;
    std::vector<float> radii_m;
    for (const Light& light : buffer.lights()) radii_m.push_back(influence_radius(pack(light), threshold));
    const auto reaches = light_reaches_box.function();
    std::vector<uint32_t> list, list_ends;
    for (const DrawItem& item : scene.items) {
        for (uint32_t i = 0; i < radii_m.size(); ++i)
            if (reaches(buffer.lights()[i], radii_m[i], item.bounds)) list.push_back(i);
        list_ends.push_back(static_cast<uint32_t>(list.size()));
    }
    frame.upload("object ends", ends, list_ends);
    frame.upload("object lights", lights, list);
}

}  // namespace lightwalk
