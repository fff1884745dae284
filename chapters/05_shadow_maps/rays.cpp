#include "05_shadow_maps/rays.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "common/base/shared_lock.h"

namespace lightwalk {
namespace {

template <class Visit>
void for_each_triangle(const DrawItem& item, const Visit& visit) {
    const Mesh& mesh = item.model->model.meshes[item.mesh];
    const Part& part = mesh.parts[item.part];
    for (uint32_t i = part.first_index; i + 2 < part.first_index + part.index_count; i += 3)
        visit(mesh.indices[i], mesh.indices[i + 1], mesh.indices[i + 2]);
}

const Mesh& mesh_of(const DrawItem& item) { return item.model->model.meshes[item.mesh]; }

uint32_t wrap_of(Wrap wrap) {
    return wrap == Wrap::repeat ? MASK_REPEATS : wrap == Wrap::mirror ? MASK_MIRRORS : MASK_CLAMPS;
}

// Alpha masks of textures that cut holes, each once. Mask 0 is one texel of 255, without holes.
class Masks {
  public:
    std::vector<RayMask> masks{{0, 1, 1, MASK_REPEATS, MASK_REPEATS}};
    std::vector<uint32_t> texels{0xff};

    explicit Masks(Gpu& gpu) : gpu_(gpu) {}
    uint32_t of(const MaterialMaps& maps, MapSlot slot, int channel) {
        const Image* const image = maps[slot].get();
        if (!image) return 0;
        const Sampler& sampler = maps.samplers[static_cast<size_t>(slot)];
        const Key key{image, channel, wrap_of(sampler.wrap), wrap_of(sampler.wrap_v.value_or(sampler.wrap))};
        const auto [place, added] = known_.try_emplace(key, 0);
        if (!added) return place->second;
        const Level level = read_level(gpu_, *image);
        place->second = unlocked([&] { return add(level, key); });
        return place->second;
    }

  private:
    struct Key {
        const Image* image;
        int channel;
        uint32_t wrap_u, wrap_v;
        auto operator<=>(const Key&) const = default;
    };

    uint32_t add(const Level& level, const Key& key) {
        const int channel = key.channel;
        const bool whole = std::all_of(level.texels.begin(), level.texels.end(),
                                       [&](const glm::vec4& texel) { return texel[channel] >= 1.0f; });
        if (whole) return 0;
        masks.push_back({static_cast<uint32_t>(texels.size()), level.size.x, level.size.y, key.wrap_u, key.wrap_v});
        for (size_t i = 0; i < level.texels.size(); ++i) {
            if (i % 4 == 0) texels.push_back(0);
            texels.back() |= static_cast<uint32_t>(std::lround(level.texels[i][channel] * 255.0f)) << 8 * (i % 4);
        }
        return static_cast<uint32_t>(masks.size() - 1);
    }
    Gpu& gpu_;
    std::map<Key, uint32_t> known_;
};

// Coordinates of a map at a vertex, as surfaces are drawn.
glm::vec2 placed_uv(const DrawItem& item, MapSlot slot, uint32_t vertex) {
    const Mesh& mesh = mesh_of(item);
    const MapPlace& place = item.maps.places[static_cast<size_t>(slot)];
    const bool second = place.set == 1 && !mesh.second_uvs.empty();
    return place.turn * (second ? mesh.second_uvs[vertex] : mesh.vertices[vertex].uv) + place.offset;
}

// True if alpha cuts holes whatever the textures say.
bool has_cut_numbers(const DrawItem& item) {
    const MaterialNumbers& of = item.material;
    return of.alpha_cutoff > 0.0f && (of.opacity < 1.0f || of.alpha_cutoff > 1.0f || !mesh_of(item).colors.empty());
}

// Cut-outs of triangles with holes.
std::vector<RayCutout> cut_with(const std::vector<glm::uvec2>& cut_by, const Scene& scene,
                                std::vector<RayTriangle>& triangles) {
    std::vector<RayCutout> with_holes;
    size_t next = 0;
    for (size_t i = 0; i < scene.items.size(); ++i) {
        const DrawItem& item = scene.items[i];
        if (item.transparent) continue;
        const glm::uvec2 masks = cut_by[i];
        const bool is_cut = masks != glm::uvec2(0) || has_cut_numbers(item);
        const std::vector<glm::vec4>& colors = mesh_of(item).colors;
        const float own = item.material.alpha_cutoff;
        for_each_triangle(item, [&](uint32_t a, uint32_t b, uint32_t c) {
            RayTriangle& triangle = triangles.at(next++);
            if (!is_cut) return;
            triangle.cutout = static_cast<uint32_t>(with_holes.size());
            RayCutout& cutout = with_holes.emplace_back();
            cutout.color_mask = masks.x;
            cutout.opacity_mask = masks.y;
            cutout.cutoff = own > 0.0f ? own : -1.0f;
            const std::array vertices{a, b, c};
            for (int k = 0; k < 3; ++k) {
                cutout.alpha[k] = item.material.opacity * (colors.empty() ? 1.0f : colors[vertices[k]].a);
                cutout.color_uv[k] = placed_uv(item, MapSlot::diffuse, vertices[k]);
                cutout.opacity_uv[k] = placed_uv(item, MapSlot::opacity, vertices[k]);
            }
        });
    }
    return with_holes;
}

}  // namespace

std::vector<RayTriangle> ray_triangles(const Scene& scene) {
    std::vector<RayTriangle> triangles;
    for (const DrawItem& item : scene.items) {
        if (item.transparent) continue;
        const std::vector<Vertex>& vertices = vertices_of(*item.model, item.mesh);
        const auto placed = [&](uint32_t i) {
            return glm::vec3(item.transform * glm::vec4(vertices[i].position, 1.0f));
        };
        for_each_triangle(item, [&](uint32_t a, uint32_t b, uint32_t c) {
            triangles.push_back({placed(a), placed(b), placed(c), NO_CUTOUT});
        });
    }
    return triangles;
}

void SceneRays::build(Gpu& gpu, const Scene& scene) {
    built_ = true;
    std::vector<RayTriangle> triangles = unlocked([&] { return ray_triangles(scene); });
    Masks masks(gpu);
    std::vector<glm::uvec2> cut_by;  // per item: masks of colour alpha and of opacity
    for (const DrawItem& item : scene.items) {
        glm::uvec2& cut = cut_by.emplace_back(0);
        if (item.transparent || item.material.alpha_cutoff == 0.0f) continue;  // 0: alpha says nothing
        const std::shared_ptr<Image>& loaded = item.loaded_maps[MapSlot::diffuse];
        const bool is_solid = loaded && scene.images() && !scene.images()->has_alpha(*loaded);
        if (!is_solid) cut.x = masks.of(item.maps, MapSlot::diffuse, 3);
        cut.y = masks.of(item.maps, MapSlot::opacity, 0);
    }
    std::vector<RayCutout> with_holes = unlocked([&] { return cut_with(cut_by, scene, triangles); });
    bvh_ = unlocked([&] { return Bvh(triangles); });
    placed_ = scene.epoch;
    set_offset();
    nodes_ = gpu.upload("ray nodes", std::as_bytes(bvh_.nodes()));
    triangles_ = gpu.upload("ray triangles", std::as_bytes(bvh_.triangles()));
    has_cutouts_ = !with_holes.empty();
    if (!has_cutouts_) with_holes.emplace_back();
    cutouts_ = gpu.upload("ray cutouts", with_holes);
    masks_ = gpu.upload("ray masks", masks.masks);
    texels_ = gpu.upload("ray mask texels", masks.texels);
}

void SceneRays::record(Frame& frame, const Scene& scene, const Maps* maps) {
    if (!built_) build(frame.gpu, scene);
    if (maps) {
        state_.cutoff = maps->cutoff;
        state_.wobble = maps->wobble;
        state_.scroll = maps->scroll;
        state_.color_cuts = maps->diffuse;
        state_.opacity_cuts = maps->opacity;
        state_.time_s = frame.time_s;
    }
    if (scene.epoch == placed_) return;
    bvh_.refit(ray_triangles(scene));
    placed_ = scene.epoch;
    set_offset();
    frame.upload("ray nodes", nodes_, std::as_bytes(bvh_.nodes()));
    frame.upload("ray triangles", triangles_, std::as_bytes(bvh_.triangles()));
}

// Macros that compile out unused cut-outs.
Macros SceneRays::macros() const {
    Macros all = Module::macros();
    if (!has_cutouts_ || !through_holes) all.set("RAYS_SOLID", "1");
    return all;
}

void Rays::record(Frame& frame, const Scene& scene, const Maps* maps) {
    state_.first_sample = static_cast<uint32_t>(frame.samples.index) * static_cast<uint32_t>(truth_samples);
    SceneRays::record(frame, scene, maps);
}

Macros Rays::macros() const {
    Macros all = SceneRays::macros();
    if (!cutouts) all.set("RAYS_SOLID", "1");
    return all;
}

std::string Rays::why_not_finite() const {
    return fmt::format(
        "{0}.truth_samples {1} may be more rays than the driver's loops have rounds for (lavapipe ends them after "
        "65,535); take {2}, and {3} times as many --samples",
        path(), truth_samples.value, std::max(truth_samples / 4, 1), truth_samples >= 4 ? 4 : truth_samples.value);
}

void SceneRays::bind(Pass& pass) const {
    pass.set_if_present("rays_nodes", nodes_);
    pass.set_if_present("rays_triangles", triangles_);
    pass.set_if_present("rays_cutouts", cutouts_);
    pass.set_if_present("rays_masks", masks_);
    pass.set_if_present("rays_texels", texels_);
    pass.set_if_present("rays_state", state_);
}

void SceneRays::set_offset() {
    const BvhNode& all = bvh_.nodes().front();
    float farthest = 0;
    for (int axis = 0; axis < 3; ++axis)
        farthest = std::max({farthest, std::fabs(all.lower[axis]), std::fabs(all.upper[axis])});
    state_.offset_m = farthest * offset_share;
}

}  // namespace lightwalk
