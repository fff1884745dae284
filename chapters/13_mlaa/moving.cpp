#include "13_mlaa/moving.h"

#include <glm/gtc/matrix_transform.hpp>

namespace lightwalk {
namespace {

bool deforms(const DrawItem& item) { return bool(item.model->model.meshes[item.mesh].deformation); }

}  // namespace

glm::mat4 without_shift(const View& view) {
    const glm::vec2 shift = 2.0f * view.crop.shift / glm::vec2(view.size);
    return glm::translate(glm::mat4(1.0f), glm::vec3(shift, 0.0f)) * view.view_projection;
}

const Buffer& Moving::vertices_before(const DrawItem& item) const {
    const auto deformed = deformed_.find({item.model.get(), item.mesh});
    return deformed == deformed_.end() ? item.model->vertices[item.mesh] : deformed->second;
}

DrawList Moving::moved_items(const Scene& scene) const {
    const bool known = placed_ != scene.epoch && transforms_.size() == scene.items.size();
    return scene.opaque().where([&](const DrawItem& item) {
        return known &&
               (deforms(item) || item.transform != transforms_[static_cast<size_t>(&item - scene.items.data())]);
    });
}

bool Moving::record(Frame& frame, const Scene& scene, const View& now, const View& before, const ImageView& depth,
                    const Drawings& drawings) {
    const DrawList moved = moved_items(scene);
    std::vector<const MovingSurface*> surfaces;
    for (const Drawing& drawing : drawings)
        if (const auto* surface = dynamic_cast<const MovingSurface*>(&drawing); surface && surface->has_moved())
            surfaces.push_back(surface);
    if (moved.size() == 0 && surfaces.empty()) return false;
    image_.ensure(frame.gpu.device, {.name = "moving", .size = now.size});
    const MotionPass all{image_, depth, {without_shift(now), without_shift(before)}};
    RasterTargets targets{.color = {clear(image_, glm::vec4(0.0f))}, .reads = {depth}};
    if (moved.size() > 0) targets.reads.emplace_back(instances_);
    for (const auto& [mesh, vertices] : deformed_) targets.reads.push_back(vertices);
    frame.raster("motion vectors", targets, [&](Raster& pass) {
        if (moved.size() == 0) return;
        pass.use(draw_).set("depth", depth, nearest_clamp).set("instances_before", instances_);
        pass.set("from_to", all.from_to);
        for (const Batch& batch : moved.batches()) {
            pass.set("vertices_before", vertices_before(batch.item()));
            batch.draw(pass);
        }
    });
    for (const MovingSurface* surface : surfaces) surface->draw_motion(frame, all);
    return true;
}

void Moving::keep(Frame& frame, const Scene& scene) {
    if (placed_ == scene.epoch) return;
    Device& device = frame.gpu.device;
    const auto copy = [&](const Buffer& from, Buffer& into, const char* name) {
        if (into.bytes != from.bytes) into = Buffer(device, {.name = name, .bytes = from.bytes});
        frame.transfer(name, {.reads = {from}, .writes = {into}}, [&](VkCommandBuffer commands) {
            const VkBufferCopy region{.size = from.bytes};
            vkCmdCopyBuffer(commands, from.handle, into.handle, 1, &region);
        });
    };
    copy(scene.instances, instances_, "instances before");
    transforms_.clear();
    for (const DrawItem& item : scene.items) {
        transforms_.push_back(item.transform);
        if (!deforms(item)) continue;
        Buffer& into = deformed_[{item.model.get(), item.mesh}];
        copy(item.model->vertices[item.mesh], into, "vertices before");
    }
    placed_ = scene.epoch;
}

}  // namespace lightwalk
