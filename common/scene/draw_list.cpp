#include "common/scene/draw_list.h"

#include <algorithm>
#include <array>

#include "common/scene/scene.h"

namespace lightwalk {
namespace {

// Looks up bindings once per pipeline and sets only those that change between items.
class Bindings {
  public:
    Bindings(Raster& pass, const Scene& scene) : pass_(pass), scene_(scene), vertices_(pass.slot("vertices")) {
        pass.set(pass.slot("instances"), scene.instances).set(pass.slot("materials"), scene.materials);
        pass.set(pass.slot("map_placements"), scene.placements);
        for (size_t map = 0; map < map_slot_count; ++map)
            if (const Pass::Slot slot = pass.slot(names()[map])) maps_[map_count_++] = {slot, map, nullptr, {}};
    }

    void set(const DrawItem& item) {
        pass_.mirrored(item.mirrored).two_sided(item.two_sided);
        if (model_ != item.model.get() || mesh_ != item.mesh) {
            pass_.set(vertices_, item.model->vertices[item.mesh]);
            for (const auto& [name, buffers] : item.model->attributes) pass_.set(pass_.slot(name), buffers[item.mesh]);
            model_ = item.model.get();
            mesh_ = item.mesh;
        }
        for (size_t i = 0; i < map_count_; ++i) {
            Wanted& wanted = maps_[i];
            const Image& image = scene_.texture(item, static_cast<MapSlot>(wanted.map));
            const Sampler& sampler = item.maps.samplers[wanted.map];
            if (wanted.set == &image && wanted.sampler == sampler) continue;
            wanted.set = &image;
            wanted.sampler = sampler;
            pass_.set(wanted.slot, image, sampler);
        }
    }

    void draw(const DrawItem& item, uint32_t first, uint32_t count) {
        set(item);
        const Part& part = item.model->model.meshes[item.mesh].parts[item.part];
        pass_.draw_indexed(item.model->indices[item.mesh], part.first_index, part.index_count, count, first);
    }

  private:
    static const std::vector<BindingName>& names() {
        static const std::vector<BindingName> all = [] {
            std::vector<BindingName> made;
            for (const auto& slot : map_slots()) made.emplace_back(slot.binding);
            return made;
        }();
        return all;
    }
    struct Wanted {
        Pass::Slot slot;
        size_t map = 0;
        const Image* set = nullptr;
        Sampler sampler{};
    };
    Raster& pass_;
    const Scene& scene_;
    const Pass::Slot vertices_;
    std::array<Wanted, map_slot_count> maps_;
    size_t map_count_ = 0;
    const GpuModel* model_ = nullptr;
    uint32_t mesh_ = 0;
};

template <class F>
void each_run(const Scene& scene, const std::vector<uint32_t>& items, F f) {
    for (size_t i = 0; i < items.size();) {
        size_t end = i + 1;
        while (end < items.size() && items[end] == items[end - 1] + 1 &&
               scene.batch_of(items[end]) == scene.batch_of(items[i]))
            ++end;
        f(items[i], static_cast<uint32_t>(end - i));
        i = end;
    }
}

}  // namespace

const DrawItem& Batch::item() const { return scene_->items[first]; }
void Batch::draw(Raster& pass) const { Bindings(pass, *scene_).draw(item(), first, count); }
void Batch::bind(Raster& pass) const { Bindings(pass, *scene_).set(item()); }

void DrawList::draw(Raster& pass) const {
    Bindings bindings(pass, *scene_);
    each_run(*scene_, items_,
             [&](uint32_t first, uint32_t count) { bindings.draw(scene_->items[first], first, count); });
}

std::vector<Batch> DrawList::batches() const {
    std::vector<Batch> result;
    each_run(*scene_, items_, [&](uint32_t first, uint32_t count) { result.emplace_back(*scene_, first, count); });
    return result;
}

DrawList DrawList::sorted_from(glm::vec3 eye) const {
    std::vector<std::pair<float, uint32_t>> far;
    far.reserve(items_.size());
    for (const uint32_t i : items_) {
        const glm::vec3 away = scene_->items[i].bounds.center() - eye;
        far.emplace_back(glm::dot(away, away), i);
    }
    std::stable_sort(far.begin(), far.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
    std::vector<uint32_t> sorted;
    sorted.reserve(far.size());
    for (const auto& [distance, i] : far) sorted.push_back(i);
    return {*scene_, std::move(sorted)};
}

// Clip planes: a point is inside if all six dot products are >= 0 (G. Gribb and K. Hartmann, 2001).
static std::array<glm::vec4, 6> planes_of(const glm::mat4& view_projection) {
    const glm::mat4 rows = glm::transpose(view_projection);
    return {rows[3] + rows[0], rows[3] - rows[0], rows[3] + rows[1], rows[3] - rows[1], rows[2], rows[3] - rows[2]};
}

static bool may_show(const Bounds& box, const std::array<glm::vec4, 6>& planes) {
    if (box.empty()) return true;
    const glm::vec3 middle = box.center(), half = 0.5f * box.extent();
    for (const glm::vec4& plane : planes) {
        const glm::vec3 normal(plane), size = glm::abs(normal);
        const float most = glm::dot(normal, middle) + plane.w + glm::dot(size, half);  // maximum over the eight corners
        const float rounding = 1e-6f * (glm::dot(size, glm::abs(middle) + half) + std::abs(plane.w));
        if (most < -rounding) return false;
    }
    return true;
}

bool may_show(const Bounds& box, const glm::mat4& view_projection) { return may_show(box, planes_of(view_projection)); }

DrawList DrawList::inside(const glm::mat4& view_projection) const {
    const std::array<glm::vec4, 6> planes = planes_of(view_projection);
    return where([&](const DrawItem& item) { return may_show(item.bounds, planes); });
}

}  // namespace lightwalk
