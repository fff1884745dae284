#include "03_attenuation/light_grid.h"

#include <cmath>

namespace lightwalk {
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
    constexpr VkDeviceSize most_bytes = 1u << 27;  // that every device can bind (the limit maxStorageBufferRange)
    for (divide(); view.tiles.x * view.tiles.y > 1 && 4 * mask_words() > most_bytes; divide()) view.tile_px *= 2;
}

// [record]
void LightGrid::record(Frame& frame, const PassInputs& lights, const ImageView& depth) {
    const uint32_t group_count = static_cast<uint32_t>((lights_ + LIGHTS_PER_GROUP - 1) / LIGHTS_PER_GROUP);
    reserve(frame.gpu.device, masks, "light masks", mask_words());
    reserve(frame.gpu.device, groups, "light groups", VkDeviceSize(group_count) * cell_count());
    if (cells_ == Cells::tiles)
        frame.compute("cull_tiles", {.reads = {depth}, .writes = {masks, groups}, .with = {lights}},
                      [&](Compute& pass) {
                          pass.use(cull_tiles_).set("depth", depth, nearest_clamp).dispatch({view.tiles, 1});
                      });
    else
        frame.compute("cull_lights", {.writes = {masks, groups}, .with = {lights}}, [&](Compute& pass) {
            pass.use(cull_lights_).dispatch_threads(glm::uvec2(cell_count(), group_count));
        });
}
// [/record]

}  // namespace lightwalk
