// Scene animation: placement of items, and the resulting uploads.
#include <algorithm>
#include <cmath>
#include <utility>

#include "common/scene/scene.h"

namespace lightwalk {
namespace {

// Uploads marked elements, contiguous ones in one copy, and clears the marks.
template <class Make>
void upload_marked(Frame& frame, const char* name, const Buffer& buffer, std::vector<bool>& marks, const Make& make) {
    auto first = std::find(marks.begin(), marks.end(), true);
    if (first == marks.end()) return;
    using Element = decltype(make(0));
    std::vector<Element> elements;
    std::vector<VkBufferCopy> parts;
    while (first != marks.end()) {
        const auto last = std::find(first, marks.end(), false);
        const auto place = static_cast<size_t>(first - marks.begin()), count = static_cast<size_t>(last - first);
        parts.push_back({.srcOffset = elements.size() * sizeof(Element),
                         .dstOffset = place * sizeof(Element),
                         .size = count * sizeof(Element)});
        for (size_t i = place; i < place + count; ++i) elements.push_back(make(i));
        first = std::find(last, marks.end(), true);
    }
    frame.upload(name, buffer, std::as_bytes(std::span(elements)), parts);
    marks.assign(marks.size(), false);
}

// For normals. What flattens has no inverse: then the cofactors, a multiple of the inverse transpose elsewhere.
glm::mat3 inverse_transpose(const glm::mat3& m) {
    if (std::isnormal(glm::determinant(m))) return glm::transpose(glm::inverse(m));
    const glm::mat3 cofactors(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1]));
    float most = 0.0f;
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row) most = std::max(most, std::abs(cofactors[column][row]));
    return most > 0.0f ? cofactors / most : glm::mat3(1.0f);
}

}  // namespace

Instance instance_of(const DrawItem& item, size_t index) {
    return {item.transform, inverse_transpose(glm::mat3(item.transform)), static_cast<uint32_t>(index)};
}

bool Scene::place(DrawItem& item) const {
    const glm::mat4 transform = objects_[item.object].world * item.model->nodes[item.node];
    const bool moved = transform != item.transform || item.bounds.empty();
    if (!moved && !item.model->model.meshes[item.mesh].deformation) return false;
    const MeshPose& pose = item.model->poses[item.mesh];
    item.transform = transform;
    item.bounds = transformed(pose.bounds, transform);
    item.mirrored = (glm::determinant(glm::mat3(transform)) < 0.0f) != pose.mirrored;
    return moved;
}

void Scene::place_objects(float time_s) {
    time_s_ = time_s;
    for (const auto& model : moving_models_) pose_model(*model, time_s);
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
        if (scene.place(item)) moved = scene.to_upload_[i] = true;
        turned_over |= item.mirrored != was_mirrored;
    }
    if (!moved) return;
    scene.epoch = Epoch::next();
    scene.bounds = {};
    for (const DrawItem& item : scene.items) scene.bounds.add(item.bounds);
    if (turned_over) scene.find_batches();
}

void Scene::upload_moved(Frame& frame) {
    if (std::exchange(uploaded_, epoch) == epoch) return;
    if (to_deform_)
        for (const auto& model : moving_models_)
            if (deforming_.contains(model.get())) deform_model(frame, *model, time_s_);
    to_deform_ = false;
    upload_marked(frame, "instances", instances, to_upload_, [&](size_t i) { return instance_of(items[i], i); });
    upload_marked(frame, "materials", materials, to_paint_,
                  [&](size_t i) { return material_data(items[i], file.emission); });
}

void Scene::find_batches() {
    batch_of_.assign(items.size(), 0);
    for (size_t i = 1; i < items.size(); ++i) {
        const DrawItem &a = items[i - 1], &b = items[i];
        const bool same = a.model == b.model && a.mesh == b.mesh && a.part == b.part && a.maps == b.maps &&
                          a.mirrored == b.mirrored && a.transparent == b.transparent && a.two_sided == b.two_sided &&
                          a.material.microfacets == b.material.microfacets;
        batch_of_[i] = batch_of_[i - 1] + (same ? 0 : 1);
    }
}

}  // namespace lightwalk
