#include "05_shadow_maps/shadow.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "common/base/exercise.h"
#include "common/gpu/gpu_work.h"

namespace lightwalk {

Shadow::Shadow(Module& owner, std::string name) : Module(owner, std::move(name), "shadow") {}

DrawList Shadow::Wanted::among_moved(const Scene& scene, bool are) const {
    std::vector<uint32_t> items;
    for (const uint32_t i : casters.items())
        if (std::ranges::binary_search(moved, i) == are) items.push_back(i);
    return {scene, std::move(items)};
}

void Shadow::Wanted::release() {
    moved.clear();
    still = {};
    still_layer = NO_LAYER;
    view.data.layer = NO_LAYER;
}

// [find_views]
// The views of all lights, those without casters without a layer.
std::vector<Shadow::Wanted> Shadow::find_views(const Scene& scene, const std::vector<Light>& lights,
                                               const std::vector<float>& reach_m, const Camera& camera,
                                               const Casters& casters, std::vector<ShadowLight>& shadow_lights) const {
    const LightViewOptions options = view_options();
    std::vector<Wanted> wanted;
    const auto has_shadow = [this](const DrawItem&) { return has_passed(); };
    Bounds bounds = scene.bounds;
    bounds.add(casters.others);
    shadow_lights.clear();
    for (const Light& light : lights) {
        ShadowLight& shadow = shadow_lights.emplace_back();
        shadow = {.position = light.position, .first_view = static_cast<uint32_t>(wanted.size())};
        if (!light.shadow || method.is("none") || bounds.empty()) continue;
        bool any = false;
        const std::vector<LightView> seen =
            light_views(light, reach_m[shadow_lights.size() - 1], bounds, camera, options);
        for (auto view = seen.begin(); view != seen.end(); ++view) {
            // Skips casters needed only by finer cascades; but the whole scene's map is the same from every
            // viewpoint.
            const auto is_needed = [&](const DrawItem& item) {
                return view->whole || std::none_of(seen.begin(), view, [&](const LightView& finer) {
                           return holds_shadow_of(finer, item.bounds, view->data.texel);
                       });
            };
            const auto inside = [&](const DrawList& list) { return list.inside(view->casters).where(is_needed); };
            const bool has_others = !casters.others.empty() && may_show(casters.others, view->casters);
            Wanted one{*view,
                       inside(scene.opaque()),
                       inside(scene.transparent()).where(has_shadow),
                       {view->view.view_projection, {}, casters.others_placed},
                       has_others};
            for (const DrawList* const list : {&one.casters, &one.passed})
                for (const uint32_t i : list->items()) one.content.casters.emplace_back(i, scene.items[i].transform);
            std::ranges::sort(one.content.casters, {}, &std::pair<uint32_t, glm::mat4>::first);
            any |= one.is_needed();
            wanted.push_back(std::move(one));
        }
        if (!any) wanted.erase(wanted.begin() + shadow.first_view, wanted.end());
        shadow.views = static_cast<uint32_t>(wanted.size()) - shadow.first_view;
        const bool parallel = light.kind == Light::Kind::directional;
        shadow.kind = parallel ? LIGHT_DIRECTIONAL : shadow.views == 6 ? LIGHT_POINT : LIGHT_SPOT;
        shadow.size = parallel ? 2.0f * std::tan(0.5f * light.size_rad) : light.size_m;
    }
    return wanted;
}
// [/find_views]

// At rest they are those of the frame before: each light's casters are searched once.
bool Shadow::find_changed_views(const Scene& scene, const LightList& lights, const Reach& reach, const Camera& camera,
                                const Casters& casters) {
    std::vector<float> reach_m(lights->size());
    for (size_t i = 0; i < lights->size(); ++i)
        if ((*lights)[i].shadow) reach_m[i] = reach((*lights)[i]);
    if (!now_->found_from.from(lights, reach_m, camera, scene.placed, casters.others, casters.others_placed,
                               view_options(), has_passed(), method.is("none"), Exercises::version()))
        return false;
    now_->settled.reset();  // now, since this frame may fail
    now_->found = find_views(scene, *lights, reach_m, camera, casters, now_->found_lights);
    ++searches;
    ++gpu_work.lists;
    return true;
}

// [choose_layers]
void Shadow::choose_layers(Frame& frame, uint32_t id, std::vector<Wanted>& wanted) {
    std::vector<const MapContent*> needed;
    for (const Wanted& w : wanted)
        if (w.is_needed()) needed.push_back(&w.content);
    views = static_cast<int>(needed.size());
    const uint32_t most = frame.gpu.device.properties.limits.maxImageArrayLayers;
    if (needed.size() > most)
        throw InputError("the lights need {} shadow maps; this device has at most {}", needed.size(), most);
    for (Wanted& w : wanted)
        if (!w.still.casters.empty() && needed.size() < most) needed.push_back(&w.still);
    const std::vector<uint32_t> chosen = layers_.choose(id, needed, most);
    auto layer = chosen.begin();
    for (Wanted& w : wanted)
        if (w.is_needed()) w.view.data.layer = *layer++;
    for (Wanted& w : wanted)
        if (!w.still.casters.empty() && layer != chosen.end()) w.still_layer = *layer++;
}
// [/choose_layers]

// [reserve]
// Layers are added when first needed, and existing contents copied. All are recreated if the size changes.
void Shadow::reserve(Frame& frame) {
    const Image::Desc wanted{.size = glm::uvec2(static_cast<uint32_t>(resolution.value)),
                             .layers = std::max(static_cast<uint32_t>(layers_.size()), 1u),
                             .kept = true};
    if (!map_ || map_.desc.size != wanted.size) layers_.forget();
    const auto copy_layers = [&](const Image& old, const Image& image) {
        if (!old || old.desc.size != image.desc.size || old.desc.format != image.desc.format) return;
        const uint32_t layers = std::min(old.desc.layers, image.desc.layers);
        frame.copy_images("shadow_copies", {{old.layer_range(0, layers), image.layer_range(0, layers)}});
    };
    const auto fit = [&](Image& image, const char* name, VkFormat of) {
        Image::Desc desc = wanted;
        desc.name = path() + name;
        desc.format = of;
        if (!image || image.desc != desc) copy_layers(std::exchange(image, Image(frame.gpu.device, desc)), image);
    };
    fit(map_, ".map", VK_FORMAT_D32_SFLOAT);
    if (has_passed()) {
        constexpr VkFormat color = VK_FORMAT_R8G8B8A8_UNORM;
        fit(first_, ".first", color);
        fit(first_depth_, ".first_depth", VK_FORMAT_D32_SFLOAT);
        fit(passed_, ".passed", color);
        fit(last_depth_, ".last_depth", VK_FORMAT_R32_SFLOAT);
    }
    if (has_moments())
        copy_layers(moments_.reserve(frame.gpu, map_,
                                     format.is("fp16") ? VK_FORMAT_R16G16B16A16_SFLOAT : VK_FORMAT_R32G32B32A32_SFLOAT),
                    moments_.moments);
}
// [/reserve]

// [draw_view]
void Shadow::draw_view(Frame& frame, const Wanted& wanted, const DrawList& list, const Attachment& depth,
                       const Casters& casters) {
    const ViewScope scope(frame, wanted.view.view);
    frame.raster("shadow_map", {.depth = depth, .with = casters.with}, [&](Raster& pass) {
        if (list.size() > 0 && casters.draw)
            casters.draw(pass, list);
        else if (list.size() > 0)
            pass.use(solid).draw(list);
        if (wanted.others && depth.load == Attachment::Load::clear) casters.draw_others(pass, wanted.view.view);
    });
}
// [/draw_view]

// [draw_passed]
// Transmittance of transparent casters: the first one's, and the product of all. A point between the first and the
// last uses the first for all before it, which is right for two.
void Shadow::draw_passed(Frame& frame, const Wanted& wanted, const Casters& casters) {
    const ViewScope scope(frame, wanted.view.view);
    const uint32_t layer = wanted.view.data.layer;
    const auto draw = [&](const char* name, std::vector<Attachment> color, Attachment depth, const Casters::Draw& by) {
        frame.raster(name, {.color = std::move(color), .depth = depth, .with = casters.with}, [&](Raster& pass) {
            if (by && wanted.passed.size() > 0) by(pass, wanted.passed);
        });
    };
    draw("shadow_first", {clear(first_.layer(layer), glm::vec4(1.0f))}, clear(first_depth_.layer(layer), 0.0f),
         casters.draw_first);
    draw("shadow_passed",
         {clear(passed_.layer(layer), glm::vec4(1.0f)), clear(last_depth_.layer(layer), glm::vec4(1.0f))},
         read_only(map_.layer(layer)), casters.draw_passed);
}
// [/draw_passed]

// [still]
// A caster that moved twice is expected to move on: static casters then get a layer of their own. Each frame copies
// it and draws the moving ones, with the same depths. A copy takes as long as a few casters that fill the map.
void Shadow::find_moving(std::vector<Wanted>& wanted) const {
    constexpr size_t few = 4;
    for (Wanted& w : wanted) {
        const MapLayers::Layer* before = keep && w.is_needed() ? layers_.before(w.content) : nullptr;
        if (!before) continue;
        w.moved = moved_between(before->content, w.content);
        MapContent still = without(w.content, w.moved);
        if (w.moved == before->moved && still.casters.size() >= few) w.still = std::move(still);
    }
}

void Shadow::copy_still(Frame& frame, const Scene& scene, const std::vector<Wanted>& wanted, const Casters& casters) {
    std::vector<std::pair<ImageView, ImageView>> copies;
    for (const Wanted& w : wanted) {
        if (w.still_layer == NO_LAYER) continue;
        const ImageView from = map_.layer(w.still_layer);
        if (layers_[w.still_layer].content != w.still) {
            draw_view(frame, w, w.among_moved(scene, false), clear(from, 0.0f), casters);
            layers_.set(w.still_layer, {w.still, w.moved});
        }
        copies.emplace_back(from, map_.layer(w.view.data.layer));
    }
    if (!copies.empty()) frame.copy_images("shadow_copies", copies);
    copied_views = static_cast<int>(copies.size());
}
// [/still]

std::optional<Shadow::BlurKey> Shadow::blur_key() const {
    if (!has_moments()) return std::nullopt;
    return BlurKey{method.index, format.index, blur_by.index, blur, exponent, exponent_negative};
}

// [record]
void Shadow::record(Frame& frame, const Scene& scene, const LightList& lights, const Reach& reach, const View& view,
                    const Casters& casters) {
    const bool has_cascades = std::ranges::any_of(
        *lights, [](const Light& light) { return light.shadow && light.kind == Light::Kind::directional; });
    const uint32_t id = has_cascades ? view.id : 0;
    now_ = &by_view_[id];
    now_->eye = {view.eye, view.pixel_rad()};
    if (made_.from(transparent.index, blur_key(), Exercises::version())) forget();
    const bool changed = find_changed_views(scene, lights, reach, has_cascades ? view.camera : Camera{}, casters);
    drawn_views = copied_views = 0;
    if (!changed && keep && now_->settled == layers_.changes()) {
        views = now_->needed;
        return;
    }
    std::vector<Wanted>& wanted = now_->found;
    for (Wanted& one : wanted) one.release();
    find_moving(wanted);
    choose_layers(frame, id, wanted);
    reserve(frame);
    std::vector<ShadowView> data;
    for (const Wanted& w : wanted) data.push_back(w.view.data);
    now_->lights.upload(frame, "shadow_lights", now_->found_lights);
    now_->views.upload(frame, "shadow_views", data);
    copy_still(frame, scene, wanted, casters);
    for (uint32_t i = 0; i < wanted.size(); ++i) {
        const Wanted& w = wanted[i];
        const uint32_t layer = w.view.data.layer;
        if (layer == NO_LAYER || (keep && layers_[layer].content == w.content)) continue;
        const ImageView into = map_.layer(layer);
        if (w.still_layer == NO_LAYER)
            draw_view(frame, w, w.casters, clear(into, 0.0f), casters);
        else
            draw_view(frame, w, w.among_moved(scene, true), lightwalk::keep(into), casters);
        if (has_passed()) draw_passed(frame, w, casters);
        if (has_moments())
            moments_.record(frame, into, now_->views.buffer, i, blur_of(blur, exponent, exponent_negative), macros());
        layers_.set(layer, {w.content, w.moved});
        ++drawn_views;
    }
    now_->needed = views;
    now_->settled.reset();
    if (drawn_views == 0 && copied_views == 0) now_->settled = layers_.changes();
}
// [/record]

void Shadow::record(Frame& frame, const Scene& scene, const Lights& lights, const View& view, const Casters& casters) {
    const auto reach = [&](const Light& light) { return lights.reach_m(light); };
    record(frame, scene, lights.buffer().list(), reach, view, casters);
}

void Shadow::record(Frame& frame, const Scene& scene, const std::vector<Light>& directional, const View& view,
                    const Casters& casters) {
    if (!directional_ || *directional_ != directional)
        directional_ = std::make_shared<const std::vector<Light>>(directional);
    record(
        frame, scene, directional_, [](const Light&) { return 0.0f; }, view, casters);
}

Macros Shadow::macros() const {
    Macros macros = Module::macros();
    if (method.is("pcss")) macros.replace_file("05_shadow_maps/filter_pcf.glsl", "05_shadow_maps/filter_pcss.glsl");
    if (has_moments()) macros.replace_file("05_shadow_maps/filter_pcf.glsl", "05_shadow_maps/filter_moments.glsl");
    return macros;
}

std::vector<Resource> Shadow::reads() const {
    std::vector<Resource> reads{map_, now_->lights.buffer, now_->views.buffer};
    if (has_moments()) reads.push_back(moments_.moments);
    if (has_passed()) reads.insert(reads.end(), {first_, first_depth_, passed_, last_depth_});
    return reads;
}

void Shadow::bind(Pass& pass) const {
    constexpr Sampler of_depth{.filter = Filter::nearest, .mip_filter = Filter::nearest, .wrap = Wrap::border};
    pass.offer("shadow_lights", now_->lights.buffer);
    pass.offer("shadow_views", now_->views.buffer);
    pass.offer("shadow_eye", now_->eye);
    pass.offer("shadow_map", map_.as_array(), of_depth);
    if (has_passed()) {
        pass.offer("shadow_first", first_.as_array(), linear_clamp);
        pass.offer("shadow_first_depth", first_depth_.as_array(), nearest_clamp);
        pass.offer("shadow_passed", passed_.as_array(), linear_clamp);
        pass.offer("shadow_last_depth", last_depth_.as_array(), nearest_clamp);
    }
    // A method without moments names them all the same, and reads none.
    pass.offer("shadow_moments", has_moments() ? moments_.moments.as_array() : map_.as_array(), linear_clamp);
}

std::vector<std::string> Shadow::status() const {
    if (views == 0) return {};
    return {fmt::format("{} shadow maps, {} drawn", views, drawn_views)};
}

}  // namespace lightwalk
