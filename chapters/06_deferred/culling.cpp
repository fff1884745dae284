#include "06_deferred/culling.h"

#include <fmt/core.h>

#include <algorithm>
#include <bit>
#include <chrono>

#include "06_deferred/culling_data.h"

namespace lightwalk {

namespace {

void reserve(Device& device, Buffer& buffer, const char* name, size_t bytes) {
    if (!buffer || buffer.bytes < bytes) buffer = Buffer(device, {.name = name, .bytes = bytes});
}

// Rounding error of float positions: a few units in the last place of the largest coordinate.
float margin_m(const Bounds& all, glm::vec3 eye) {
    const glm::vec3 farthest = all.empty() ? glm::abs(eye) : glm::max(glm::max(-all.lower, all.upper), glm::abs(eye));
    return 2e-6f * (farthest.x + farthest.y + farthest.z);
}

CulledObject culled_object(const DrawItem& item, uint32_t group) {
    if (item.bounds.empty()) return {glm::vec3(0.0f), -1.0f, glm::vec3(0.0f), group};
    const glm::vec3 half = 0.5f * item.bounds.extent();
    return {item.bounds.center(), glm::length(half), half, group};
}

}  // namespace

Culling::Culling(Module& owner, std::string name) : Module(owner, std::move(name), "culling") {}

std::array<glm::vec4, 6> view_planes(const glm::mat4& view_projection, float margin_m) {
    const glm::mat4 rows = glm::transpose(view_projection);
    std::array<glm::vec4, 6> planes{rows[3] + rows[0], rows[3] - rows[0], rows[3] + rows[1],
                                    rows[3] - rows[1], rows[2],           rows[3] - rows[2]};
    for (glm::vec4& plane : planes) {
        const float length = glm::length(glm::vec3(plane));
        plane = length > 0.0f ? plane / length + glm::vec4(0, 0, 0, margin_m) : glm::vec4(0, 0, 0, 1);
    }
    return planes;
}

void Culling::begin(Frame& frame, const Scene& scene, const View& view, const std::vector<Batch>& batches) {
    const auto start = std::chrono::steady_clock::now();
    scene_ = &scene;
    view_id_ = view.id;
    to_clip_ = view.view_projection;
    planes_ = view_planes(to_clip_, margin_m(scene.bounds, view.eye));
    listed_ = false;
    list_count_ = 0;
    size_t objects = 0;
    for (const Batch& batch : batches) objects += batch.count;
    const bool pays = !method.is("none") && objects >= static_cast<size_t>(least.value);
    group(frame, pays ? batches : std::vector<Batch>());
    if (culls() && method.is("frustum_cpu")) find();
    host_ms_ = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

void Culling::group(Frame& frame, const std::vector<Batch>& batches) {
    std::vector<uint32_t> ends;
    for (const Batch& batch : batches) ends.push_back(batch.first + batch.count);
    const bool on_host = method.is("frustum_cpu");
    if (grouped_.is_current(scene_->epoch, ends, on_host)) return;
    groups_.clear();
    objects_.assign(ends.empty() ? 0 : *std::max_element(ends.begin(), ends.end()),
                    {.radius = -1.0f, .group = NO_GROUP});
    for (const Batch& batch : batches) {
        const DrawItem& item = batch.item();
        const Part& part = item.model->model.meshes[item.mesh].parts[item.part];
        const auto number = static_cast<uint32_t>(groups_.size());
        groups_.push_back({batch.first, batch.count, part.first_index, part.index_count});
        for (uint32_t i = batch.first; i < batch.first + batch.count; ++i)
            objects_[i] = culled_object(scene_->items[i], number);
    }
    if (groups_.empty() || on_host) return;
    frame.upload("objects to cull", object_data_, objects_);
    frame.upload("draw groups", group_data_, groups_);
}

// CPU culling; adjacent visible objects stay one draw call.
void Culling::find() {
    const bool by_box = bounds.is("box");
    const auto is_outside = [&](const CulledObject& object) {
        for (const glm::vec4& plane : planes_) {
            const glm::vec3 normal(plane);
            const float reach = by_box ? glm::dot(glm::abs(normal), object.half_size) : object.radius;
            if (glm::dot(normal, object.center) + plane.w < -reach) return true;
        }
        return false;
    };
    found_.assign(groups_.size(), {});
    for (size_t g = 0; g < groups_.size(); ++g) {
        const uint32_t end = groups_[g].first + groups_[g].count;
        for (uint32_t i = groups_[g].first; i < end; ++i) {
            if (objects_[i].radius >= 0.0f && is_outside(objects_[i])) continue;
            std::vector<Batch>& found = found_[g];
            if (!found.empty() && found.back().first + found.back().count == i)
                ++found.back().count;
            else
                found.emplace_back(*scene_, i, 1u);
        }
    }
}

// [passes]
void Culling::passes(Frame& frame, const ImageView& depth, const std::function<void()>& record) {
    if (!culls() || method.is("frustum_cpu") || listed_) return record();
    listed_ = true;
    const bool hidden_too = method.is("occlusion") && depth.image->desc.samples == 1;

    // 1. Objects in the view that the previous frame did not hide.
    list(frame, hidden_too && view_seen().pyramid.levels() > 0 ? seen_before_ : all_, 0);
    list_count_ = 1;
    record();
    if (!hidden_too) return;

    // 2. Depth pyramid, then the remaining objects that it does not hide. None is lost: each object is in the first
    // list or tested here against this frame's depths.
    view_seen().pyramid.record(frame, depth);
    view_seen().to_clip = to_clip_;
    list_count_ = 0;
    list(frame, appearing_, 1);
    first_list_ = 1;
    list_count_ = 1;
    record();
    first_list_ = 0;
    list_count_ = 2;
}
// [/passes]

Culling::Seen& Culling::view_seen() {
    return seen_.try_emplace(view_id_, fmt::format("{} pyramid {}", path(), view_id_)).first->second;
}

void Culling::list(Frame& frame, const Pipeline& which, size_t into) {
    Device& device = frame.gpu.device;
    List& list = lists_[into];
    const auto objects = static_cast<uint32_t>(objects_.size()), groups = static_cast<uint32_t>(groups_.size());
    reserve(device, list.ranks, "ranks of objects", sizeof(uint32_t) * objects);
    reserve(device, list.sums, "listed before", sizeof(uint32_t) * (objects / LIST_GROUP + 1));
    reserve(device, list.total, "objects listed", sizeof(uint32_t));
    reserve(device, list.instances, "instances listed", sizeof(Instance) * objects);
    reserve(device, list.draws, "draws", sizeof(DrawCommand) * groups);
    const Seen& seen = view_seen();
    const DepthPyramid& pyramid = seen.pyramid;
    CullingView look{.to_clip = seen.to_clip,
                     .pyramid_pixels = glm::vec2(pyramid.pixels()),
                     .pyramid_levels = pyramid.levels(),
                     .objects = objects,
                     .groups = groups};
    std::copy(planes_.begin(), planes_.end(), look.planes);

    ComputeAccess access{.reads = {object_data_, group_data_, scene_->instances, list.ranks, list.sums, list.total},
                         .writes = {list.ranks, list.sums, list.total, list.instances, list.draws},
                         .with = {*this}};
    if (pyramid.levels() > 0) access.reads.emplace_back(pyramid.image());
    if (into > 0) access.reads.emplace_back(lists_[0].ranks);
    frame.compute(into > 0 ? "list the objects left" : "list objects", access, [&](Compute& pass) {
        pass.use(which).set("objects", object_data_).set("ranks", list.ranks).set("sums", list.sums).set("look", look);
        if (pyramid.levels() > 0) pass.set_if_present("pyramid", pyramid.image(), nearest_clamp);
        if (into > 0) pass.set("earlier", lists_[0].ranks);
        if (objects > 0) pass.dispatch_threads(glm::uvec2(objects, 1)).wait();
        pass.use(sum_).set("sums", list.sums).set("total", list.total).set("look", look);
        pass.dispatch({1, 1, 1}).wait();
        pass.use(write_).set("objects", object_data_).set("groups", group_data_).set("ranks", list.ranks);
        pass.set("sums", list.sums).set("total", list.total).set("instances", scene_->instances).set("look", look);
        pass.set("listed_instances", list.instances).set("draws", list.draws);
        if (objects > 0) pass.dispatch_threads(glm::uvec2(std::max(objects, groups), 1));
    });
    frame.read_back(list.total, list.count);
}

void Culling::draw(Raster& pass, const Batch& batch) const {
    if (!culls()) {
        pass.draw(batch);
        return;
    }
    const uint32_t group = objects_[batch.first].group;
    if (method.is("frustum_cpu")) {
        for (const Batch& found : found_[group]) pass.draw(found);
        return;
    }
    const DrawItem& item = batch.item();
    batch.bind(pass);
    for (size_t i = first_list_; i < first_list_ + list_count_; ++i) {
        pass.set("instances", lists_[i].instances);
        pass.draw_indexed_indirect(item.model->indices[item.mesh], lists_[i].draws, 1, group * sizeof(DrawCommand));
    }
}

std::vector<Resource> Culling::reads() const {
    std::vector<Resource> all;
    for (size_t i = first_list_; i < first_list_ + list_count_; ++i) {
        all.emplace_back(lists_[i].instances);
        all.emplace_back(lists_[i].draws);
    }
    return all;
}

size_t Culling::drawn() const {
    size_t count = 0;
    if (method.is("frustum_cpu")) {
        for (const auto& found : found_)
            for (const Batch& batch : found) count += batch.count;
        return count;
    }
    for (const List& list : lists_)
        if (list.count && (&list == lists_ || method.is("occlusion"))) count += list.count.as<uint32_t>()[0];
    return count;
}

std::vector<std::string> Culling::status() const {
    if (!culls()) return {};
    return {fmt::format("{} of {} objects drawn", drawn(), objects_.size())};
}

void DepthPyramid::record(Frame& frame, const ImageView& depth) {
    pixels_ = depth.size();
    const glm::uvec2 half = glm::max(pixels_ / 2u, 1u);
    const auto levels = static_cast<uint32_t>(std::bit_width(std::max(half.x, half.y)));
    image_.ensure(frame.gpu.device,
                  {.name = name_, .format = VK_FORMAT_R32_SFLOAT, .size = half, .mips = levels, .kept = true});
    const ImageView all(image_);
    frame.compute("depth pyramid", {.reads = {depth, all}, .writes = {all}}, [&](Compute& pass) {
        pass.use(five_levels_);
        for (uint32_t first = 0; first < levels; first += PYRAMID_STEP) {
            if (first > 0) pass.wait();  // for the previous level
            const ImageView source = first > 0 ? all.mip(first - 1) : depth;
            std::vector<ImageView> made;
            for (uint32_t m = first; m < std::min(levels, first + PYRAMID_STEP); ++m) made.push_back(all.mip(m));
            pass.set("source", source, nearest_clamp).set("level", std::span<const ImageView>(made));
            pass.set("pyramid_step", static_cast<int>(made.size()));
            const glm::uvec2 groups = glm::max(glm::uvec2(source.size()) >> PYRAMID_STEP, 1u);
            pass.dispatch({groups, 1});
        }
    });
}

}  // namespace lightwalk
