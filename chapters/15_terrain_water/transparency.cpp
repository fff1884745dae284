#include "15_terrain_water/transparency.h"

#include <algorithm>

#include "15_terrain_water/exercises.h"
#include "common/base/text.h"

namespace lightwalk {

Transparency::Transparency(Module& owner, std::string name) : Module(owner, std::move(name), "transparency") {}

// Replacement for the end of surfaces' fragment shaders in one pass, and its resources.
class Transparency::Stage : public PassInputs {
  public:
    Stage(std::string file, TransparencyNow now) : file_(std::move(file)), now_(now) {}
    Stage& image(const char* name, const ImageView& view) {
        images_.emplace_back(name, view);
        return *this;
    }
    Stage& buffer(const char* name, const Buffer& buffer) {
        buffers_.emplace_back(name, &buffer);
        return *this;
    }
    const std::string& kind() const override { return kind_; }
    Macros macros() const override { return Macros().replace_file("common/put_surface.glsl", file_); }
    std::span<const std::byte> block(const Binding&) const override { return {}; }
    std::vector<Resource> reads() const override {
        std::vector<Resource> all;
        for (const auto& [name, view] : images_) all.emplace_back(view);
        return all;
    }
    void bind(Pass& pass) const override {
        pass.set_if_present("transparency_now", now_);
        for (const auto& [name, view] : images_) pass.set_if_present(name, view, nearest_clamp);
        for (const auto& [name, one] : buffers_) pass.set_if_present(name, *one);
    }

  private:
    std::string kind_ = "put_surface", file_;
    TransparencyNow now_;
    std::vector<std::pair<const char*, ImageView>> images_;
    std::vector<std::pair<const char*, const Buffer*>> buffers_;
};

namespace {

constexpr glm::vec4 nothing(0.0f), everything(1.0f);
constexpr const char* blended = "15_terrain_water/put_blended.glsl";

// By drawing: a method that needs no order wants as few passes as there are drawings.
std::vector<TransparentSurface> grouped(std::vector<TransparentSurface> surfaces) {
    std::stable_sort(surfaces.begin(), surfaces.end(), [](const TransparentSurface& a, const TransparentSurface& b) {
        return std::less<const TransparentSource*>()(a.source, b.source);
    });
    return surfaces;
}

std::vector<TransparentSurface> back_to_front(const std::vector<TransparentSurface>& surfaces, glm::vec3 eye) {
    std::vector<glm::vec3> middles;
    for (const TransparentSurface& surface : surfaces) middles.push_back(surface.what.middle);
    std::vector<TransparentSurface> sorted;
    for (const uint32_t i : sort_back_to_front(middles, eye))
        if (i < surfaces.size()) sorted.push_back(surfaces[i]);
    return sorted;
}

void make_buffer(Frame& frame, Buffer& buffer, const char* name, VkDeviceSize bytes) {
    if (buffer.bytes != bytes) buffer = Buffer(frame.gpu.device, {.name = name, .bytes = bytes});
}

}  // namespace

void Transparency::record(Frame& frame, const View& view, Canvas& canvas,
                          const std::vector<TransparentSurface>& surfaces) {
    float farthest = 0;
    for (const TransparentSurface& surface : surfaces) farthest = std::max(farthest, surface.what.distance_m);
    const float near_m = view.camera.near_m;
    now_ = {.near_m = near_m,
            .far_m = std::max(std::min(view.camera.far_m, 4.0f * farthest), 2.0f * near_m),
            .width = canvas.size().x,
            .moment_bias = moment_bias,
            .overestimation = overestimation};
    Targets& t = targets_[view.id];
    if (method.is("wboit")) return add_weighted(frame, canvas, grouped(surfaces), t);
    if (method.is("moments") || method.is("moments6")) return add_by_moments(frame, canvas, grouped(surfaces), t);
    if (method.is("lists")) return mix_lists(frame, canvas, grouped(surfaces), t);
    if (method.is("peeling")) return peel(frame, canvas, grouped(surfaces), t);
    if (method.is("sorted_triangles")) return draw_triangles(frame, view, canvas, surfaces, t);
    draw_stage(frame, "transparent", {.color = {canvas.color_target()}, .depth = canvas.depth_read_only()},
               Stage(blended, now_), method.is("sorted") ? back_to_front(surfaces, view.eye) : surfaces);
}

void Transparency::draw_stage(Frame& frame, const char* pass, RasterTargets targets, const Stage& stage,
                              const std::vector<TransparentSurface>& surfaces) {
    targets.with.insert(targets.with.end(), {*this, stage});
    draw_surfaces(frame, pass, std::move(targets), surfaces);
}

void Transparency::draw_triangles(Frame& frame, const View& view, Canvas& canvas,
                                  const std::vector<TransparentSurface>& surfaces, Targets& t) {
    struct One {
        const TransparentSource* source;
        TransparentSource::TransparentTriangle what;
    };
    std::vector<One> all;
    std::set<const TransparentSource*> asked;
    for (const TransparentSurface& surface : surfaces)
        if (asked.insert(surface.source).second)
            for (const auto& triangle : surface.source->transparent_triangles(view))
                all.push_back({surface.source, triangle});
    if (all.empty()) return;
    std::stable_sort(all.begin(), all.end(),
                     [](const One& a, const One& b) { return a.what.distance_m > b.what.distance_m; });
    std::vector<glm::uvec3> indices;
    for (const One& one : all) indices.push_back(one.what.vertices);
    frame.upload("sorted triangles", t.indices, indices);
    const Stage stage(blended, now_);
    for (size_t first = 0, last = 0; first < all.size(); first = last) {
        const TransparentSource& source = *all[first].source;
        while (last < all.size() && all[last].source == &source) ++last;
        std::vector<With> with = source.transparent_with();
        with.insert(with.end(), {*this, stage});
        frame.raster("transparent",
                     {.color = {canvas.color_target()},
                      .depth = canvas.depth_read_only(),
                      .reads = source.transparent_reads(),
                      .with = with},
                     [&](Raster& pass) {
                         for (size_t from = first, to = first; from < last; from = to) {  // neighbours of one item
                             while (to < last && all[to].what.item == all[from].what.item) ++to;
                             source.draw_transparent_triangles(pass, all[from].what.item, t.indices,
                                                               static_cast<uint32_t>(3 * from),
                                                               static_cast<uint32_t>(3 * (to - from)));
                         }
                     });
    }
}

void Transparency::add_weighted(Frame& frame, Canvas& canvas, const std::vector<TransparentSurface>& surfaces,
                                Targets& t) {
    const glm::uvec2 size = canvas.size();
    const VkFormat share = revealage.is("r8") ? VK_FORMAT_R8G8B8A8_UNORM : VK_FORMAT_R16G16B16A16_SFLOAT;
    t.sum.ensure(frame.gpu.device, {.name = path() + " sum", .format = sum_format(), .size = size});
    t.share.ensure(frame.gpu.device, {.name = path() + " share", .format = share, .size = size});
    draw_stage(frame, "weighted sum",
               {.color = {clear(t.sum, nothing), clear(t.share, everything)},
                .depth = canvas.depth_read_only(),
                .blend_override = BlendOverride{{Blend::add, Blend::multiply}}},
               Stage("15_terrain_water/put_weighted.glsl", now_), surfaces);
    const ImageView color = canvas.color(frame);
    frame.compute("mix", {.reads = {t.sum, t.share, color}, .writes = {color}}, [&](Compute& pass) {
        pass.use(mix_weighted_).set("sum", t.sum, nearest_clamp).set("share", t.share, nearest_clamp);
        pass.set("picture", color).dispatch_threads(size);
    });
}

void Transparency::add_by_moments(Frame& frame, Canvas& canvas, const std::vector<TransparentSurface>& surfaces,
                                  Targets& t) {
    const glm::uvec2 size = canvas.size();
    t.moments.ensure(frame.gpu.device,
                     {.name = path() + " moments", .format = VK_FORMAT_R32G32B32A32_SFLOAT, .size = size});
    // Beside the absorbance there is room for the fifth moment and the sixth.
    const VkFormat beside = method.is("moments6") ? VK_FORMAT_R32G32B32A32_SFLOAT : VK_FORMAT_R32_SFLOAT;
    t.absorbance.ensure(frame.gpu.device, {.name = path() + " absorbance", .format = beside, .size = size});
    t.tints.ensure(frame.gpu.device, {.name = path() + " tints", .size = size});
    t.sum.ensure(frame.gpu.device, {.name = path() + " sum", .format = sum_format(), .size = size});
    draw_stage(frame, "moments",
               {.color = {clear(t.moments, nothing), clear(t.absorbance, nothing), clear(t.tints, everything)},
                .depth = canvas.depth_read_only(),
                .blend_override = BlendOverride{{Blend::add, Blend::add, Blend::multiply}}},
               Stage("15_terrain_water/put_moments.glsl", now_), surfaces);
    Stage second("15_terrain_water/put_transmitted.glsl", now_);
    second.image("moments", t.moments).image("absorbance", t.absorbance);
    draw_stage(frame, "transmitted sum",
               {.color = {clear(t.sum, nothing)},
                .depth = canvas.depth_read_only(),
                .blend_override = BlendOverride{{Blend::add}}},
               second, surfaces);
    const ImageView color = canvas.color(frame);
    frame.compute("mix", {.reads = {t.sum, t.absorbance, t.tints, color}, .writes = {color}}, [&](Compute& pass) {
        pass.use(mix_moments_).set("sum", t.sum, nearest_clamp).set("absorbance", t.absorbance, nearest_clamp);
        pass.set("tints", t.tints, nearest_clamp).set("picture", color).dispatch_threads(size);
    });
}

// The frame waits for the number of fragments, and lists them again if they had no room.
void Transparency::mix_lists(Frame& frame, Canvas& canvas, const std::vector<TransparentSurface>& surfaces,
                             Targets& t) {
    const glm::uvec2 size = canvas.size();
    const auto most = static_cast<uint32_t>(
        std::min(frame.gpu.device.properties.limits.maxStorageBufferRange, 1u << 30) / sizeof(ListedFragment));
    t.room = std::clamp(size.x * size.y * static_cast<uint32_t>(list_fragments), t.room, most);
    make_buffer(frame, t.heads, "list heads", VkDeviceSize(size.x) * size.y * sizeof(uint32_t));
    make_buffer(frame, t.count, "list count", 16);
    while (true) {
        now_.capacity = t.room;
        make_buffer(frame, t.fragments, "listed fragments", VkDeviceSize(t.room) * sizeof(ListedFragment));
        frame.compute("clear lists", {.writes = {t.heads, t.count}}, [&](Compute& pass) {
            pass.use(clear_lists_).set("list_heads", t.heads).set("list_count", t.count);
            pass.dispatch_threads(glm::uvec3(size.x * size.y, 1, 1));
        });
        Stage stage("15_terrain_water/put_listed.glsl", now_);
        stage.buffer("list_heads", t.heads).buffer("listed", t.fragments).buffer("list_count", t.count);
        draw_stage(frame, "lists",
                   {.depth = canvas.depth_read_only(),
                    .reads = {t.heads, t.fragments, t.count},
                    .writes = {t.heads, t.fragments, t.count},
                    .blend_override = BlendOverride{}},
                   stage, surfaces);
        frame.read_back(t.count, t.counted);
        frame.finish();
        listed_ = t.counted.as<uint32_t>()[0];
        if (listed_ <= t.room) break;
        if (t.room == most) {
            warn_once(
                fmt::format("{}: the lists have room for {} fragments on this device, and the others are not drawn; "
                            "draw a smaller picture, or set {}.method=peeling",
                            path(), most, path()));
            break;
        }
        t.room = std::min(most, listed_ + listed_ / 8);
    }
    const ImageView color = canvas.color(frame);
    frame.compute("mix", {.reads = {t.heads, t.fragments, color}, .writes = {color}}, [&](Compute& pass) {
        pass.use(mix_lists_).set("list_heads", t.heads).set("listed", t.fragments).set("picture", color);
        pass.dispatch_threads(size);
    });
}

std::vector<std::string> Transparency::status() const {
    if (!method.is("lists") || listed_ == 0) return {};
    return {fmt::format("{} fragments of transparent surfaces", listed_)};
}

void Transparency::peel(Frame& frame, Canvas& canvas, const std::vector<TransparentSurface>& surfaces, Targets& t) {
    const glm::uvec2 size = canvas.size();
    t.layer.ensure(frame.gpu.device, {.name = path() + " layer", .size = size});
    t.layer_tint.ensure(frame.gpu.device, {.name = path() + " layer tint", .size = size});
    for (Image& depth : t.layer_depth)
        depth.ensure(frame.gpu.device, {.name = path() + " layer depth", .format = VK_FORMAT_D32_SFLOAT, .size = size});
    for (Image* image : {&t.peeled, &t.passed})
        image->ensure(frame.gpu.device, {.name = path() + (image == &t.peeled ? " peeled" : " passed"),
                                         .format = VK_FORMAT_R32G32B32A32_SFLOAT,
                                         .size = size});
    frame.fill("clear peeled", t.peeled, nothing);
    frame.fill("clear passed", t.passed, everything);
    // Before the first layer there is the near plane.
    frame.raster("before the layers", {.depth = clear(t.layer_depth[1], 1.0f)}, [](Raster&) {});
    const ImageView& solid = canvas.single_depth();
    for (int i = 0; i < peels; ++i) {
        Image &nearer = t.layer_depth[(i + 1) % 2], &depth = t.layer_depth[i % 2];
        Stage stage("15_terrain_water/put_layer.glsl", now_);
        stage.image("solid_depth", solid).image("nearer_depth", nearer);
        draw_stage(frame, "layer",
                   {.color = {clear(t.layer, nothing), clear(t.layer_tint, everything)},
                    .depth = clear(depth, 0.0f),
                    .blend_override = BlendOverride{{Blend::opaque}, true}},
                   stage, surfaces);
        frame.compute("add layer",
                      {.reads = {t.layer, t.layer_tint, t.peeled, t.passed}, .writes = {t.peeled, t.passed}},
                      [&](Compute& pass) {
                          pass.use(add_layer_).set("layer", t.layer, nearest_clamp);
                          pass.set("layer_tint", t.layer_tint, nearest_clamp);
                          pass.set("peeled", t.peeled).set("passed", t.passed).dispatch_threads(size);
                      });
    }
    const ImageView color = canvas.color(frame);
    frame.compute("mix", {.reads = {t.peeled, t.passed, color}, .writes = {color}}, [&](Compute& pass) {
        pass.use(mix_peeled_).set("peeled", t.peeled, nearest_clamp).set("passed", t.passed, nearest_clamp);
        pass.set("picture", color).dispatch_threads(size);
    });
}

}  // namespace lightwalk
