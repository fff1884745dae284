// Placement of a scene's items at a time, and the resulting updates to the device.
#include <atomic>

#include "common/scene/scene.h"

namespace lightwalk {
namespace {

// Records the upload of instances from `first` on.
void upload(VkCommandBuffer commands, const Buffer& buffer, size_t first, const std::vector<Instance>& data) {
    constexpr size_t most = 65536 / sizeof(Instance);  // vkCmdUpdateBuffer takes 64 KiB
    for (size_t at = 0; at < data.size(); at += most)
        vkCmdUpdateBuffer(commands, buffer.handle, (first + at) * sizeof(Instance),
                          std::min(most, data.size() - at) * sizeof(Instance), &data[at]);
}

}  // namespace

uint64_t next_placement() {
    static std::atomic<uint64_t> count = 0;
    return ++count;
}

Instance instance_of(const DrawItem& item, size_t index) {
    return {item.transform, glm::transpose(glm::inverse(glm::mat3(item.transform))), static_cast<uint32_t>(index)};
}

// True if it is elsewhere now.
bool Scene::place(DrawItem& item) const {
    const glm::mat4 transform = objects_[item.object].world * item.model->nodes[item.node];
    if (transform == item.transform && !item.bounds.empty()) return false;
    item.transform = transform;
    item.bounds = transformed(item.model->model.meshes[item.mesh].bounds, transform);
    item.mirrored = glm::determinant(glm::mat3(transform)) < 0.0f;
    return true;
}

void Scene::place_objects(float time_s) {
    time_s_ = time_s;
    for (const auto& model : moving_models_) model->nodes = world_transforms(model->model, time_s);
    for (size_t i = 0; i < objects_.size(); ++i) {
        Placed& object = objects_[i];
        if (!object.moves) continue;
        const glm::mat4 local = file.objects[i].motion ? local_transform(file.objects[i], time_s) : object.local;
        object.world = object.parent < 0 ? local : objects_[static_cast<size_t>(object.parent)].world * local;
    }
}

void animate(Scene& scene, float time_s) {
    if (!scene.moves()) return;
    scene.place_objects(time_s);
    bool moved = !scene.deforming_.empty(), turned_over = false;
    scene.to_deform_ = moved;
    for (const uint32_t i : scene.moving_items_) {
        DrawItem& item = scene.items[i];
        const bool was_mirrored = item.mirrored;
        if (!scene.place(item)) continue;
        moved = scene.to_upload_[i] = true;
        turned_over |= item.mirrored != was_mirrored;
    }
    if (!moved) return;
    scene.placed = next_placement();
    scene.bounds = {};
    for (const DrawItem& item : scene.items) scene.bounds.add(item.bounds);
    if (turned_over) scene.find_batches();
}

void Scene::upload_moved(Frame& frame) {
    if (to_deform_)
        for (const auto& model : moving_models_)
            if (deforming_.contains(model.get())) deform_model(frame, *model, time_s_);
    to_deform_ = false;
    const auto first = std::find(to_upload_.begin(), to_upload_.end(), true);
    if (first == to_upload_.end()) return;
    frame.transfer("instances", {.reads = {}, .writes = {instances}}, [&](VkCommandBuffer commands) {
        std::vector<Instance> run;
        for (size_t i = static_cast<size_t>(first - to_upload_.begin()); i <= items.size(); ++i) {
            if (i < items.size() && to_upload_[i]) {
                run.push_back(instance_of(items[i], i));
            } else if (!run.empty()) {
                upload(commands, instances, i - run.size(), run);
                frame.gpu.uploaded_bytes += run.size() * sizeof(Instance);
                run.clear();
            }
        }
    });
    to_upload_.assign(items.size(), false);
}

void Scene::find_batches() {
    batch_of_.assign(items.size(), 0);
    for (size_t i = 1; i < items.size(); ++i) {
        const DrawItem &a = items[i - 1], &b = items[i];
        const bool same = a.model == b.model && a.mesh == b.mesh && a.part == b.part && a.maps == b.maps &&
                          a.mirrored == b.mirrored && a.transparent == b.transparent && a.two_sided == b.two_sided;
        batch_of_[i] = batch_of_[i - 1] + (same ? 0 : 1);
    }
}

}  // namespace lightwalk
