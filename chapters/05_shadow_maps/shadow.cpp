#include "05_shadow_maps/shadow.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "common/base/exercise.h"

namespace lightwalk {

Shadow::Shadow(Module& owner, std::string name) : Module(owner, std::move(name), "shadow") {}

// [find_views]
// The views of all lights, those without casters without a layer.
std::vector<Shadow::Wanted> Shadow::find_views(const Scene& scene, const std::vector<Light>& lights, const Reach& reach,
                                               const Camera& camera, const Casters& casters) {
    const LightViewOptions options{resolution, near_m, cascades, split, distance_m, snap};
    std::vector<Wanted> wanted;
    const auto has_shadow = [this](const DrawItem&) { return has_passed(); };
    Bounds bounds = scene.bounds;
    bounds.add(casters.others);
    shadow_lights_.clear();
    for (const Light& light : lights) {
        ShadowLight& shadow = shadow_lights_.emplace_back();
        shadow = {.position = light.position, .first_view = static_cast<uint32_t>(wanted.size())};
        if (!light.shadow || method.is("none") || bounds.empty()) continue;
        bool any = false;
        for (const LightView& view : light_views(light, reach(light), bounds, camera, options)) {
            const auto inside = [&](const DrawList& list) { return list.inside(view.casters); };
            Wanted one{view,
                       inside(scene.opaque()),
                       inside(scene.transparent()).where(has_shadow),
                       {view.view.view_projection, {}, casters.others_placed},
                       !casters.others.empty()};
            for (const DrawList* const list : {&one.casters, &one.passed})
                for (const uint32_t i : list->items()) one.key.casters.emplace_back(i, scene.items[i].transform);
            any |= one.is_needed();
            wanted.push_back(std::move(one));
        }
        if (!any) wanted.erase(wanted.begin() + shadow.first_view, wanted.end());
        shadow.views = static_cast<uint32_t>(wanted.size()) - shadow.first_view;
        const bool parallel = light.kind == Light::Kind::directional;
        shadow.kind = parallel ? LIGHT_DIRECTIONAL : shadow.views == 6 ? LIGHT_POINT : LIGHT_SPOT;
        shadow.size = parallel ? 2.0f * std::tan(0.5f * light.size_rad) : light.size_m;
    }
    uint32_t layer = 0;
    for (Wanted& w : wanted)
        if (w.is_needed()) w.view.data.layer = layer++;
    return wanted;
}
// [/find_views]

// Layers are made when they are first needed, all of them anew where the size has changed.
void Shadow::reserve(Frame& frame, uint32_t layers) {
    const uint32_t most = frame.gpu.device.properties.limits.maxImageArrayLayers;
    if (layers > most) throw InputError("the lights need {} shadow maps; this device has at most {}", layers, most);
    const Image::Desc wanted{.name = path() + ".map",
                             .format = VK_FORMAT_D32_SFLOAT,
                             .size = glm::uvec2(static_cast<uint32_t>(resolution.value)),
                             .layers = std::max({layers, now_->map ? now_->map.desc.layers : 0u, 1u}),
                             .kept = true};
    if (!now_->map || now_->map.desc != wanted) {
        now_->map = Image(frame.gpu.device, wanted);
        now_->drawn.assign(wanted.layers, {});
        frame.raster("clear_shadows", {.depth = clear(now_->map.as_array(), 0.0f), .layers = wanted.layers},
                     [](Raster&) {});
    }
    if (has_passed()) {
        constexpr VkFormat color = VK_FORMAT_R8G8B8A8_UNORM;
        const auto fit = [&](Image& image, const char* name, VkFormat of) {
            Image::Desc desc = wanted;
            desc.name = path() + name, desc.format = of;
            image.fit(frame.gpu.device, desc);
        };
        fit(now_->first, ".first", color), fit(now_->first_depth, ".first_depth", VK_FORMAT_D32_SFLOAT);
        fit(now_->passed, ".passed", color), fit(now_->last_depth, ".last_depth", VK_FORMAT_R32_SFLOAT);
    }
    if (!has_moments()) return;
    if (now_->moments.reserve(frame.gpu, now_->map,
                              format.is("fp16") ? VK_FORMAT_R16G16B16A16_SFLOAT : VK_FORMAT_R32G32B32A32_SFLOAT))
        now_->drawn.assign(now_->drawn.size(), {});
}

// [draw_view]
void Shadow::draw_view(Frame& frame, const Wanted& wanted, const Casters& casters) {
    const ViewScope scope(frame, wanted.view.view);
    frame.raster("shadow_map", {.depth = clear(now_->map.layer(wanted.view.data.layer), 0.0f), .with = casters.with},
                 [&](Raster& pass) {
                     if (wanted.casters.size() > 0 && casters.draw)
                         casters.draw(pass, wanted.casters);
                     else if (wanted.casters.size() > 0)
                         pass.use(solid).draw(wanted.casters);
                     if (wanted.others) casters.draw_others(pass, wanted.view.view);
                 });
}
// [/draw_view]

// [draw_passed]
// What transparent casters let through: the first, and the product of all. A point between the first and the last takes
// the first for all that are before it, which is right for two.
void Shadow::draw_passed(Frame& frame, const Wanted& wanted, const Casters& casters) {
    const ViewScope scope(frame, wanted.view.view);
    const uint32_t layer = wanted.view.data.layer;
    const auto draw = [&](const char* name, std::vector<Attachment> color, Attachment depth, const Casters::Draw& by) {
        frame.raster(name, {.color = std::move(color), .depth = depth, .with = casters.with}, [&](Raster& pass) {
            if (by && wanted.passed.size() > 0) by(pass, wanted.passed);
        });
    };
    draw("shadow_first", {clear(now_->first.layer(layer), glm::vec4(1.0f))},
         clear(now_->first_depth.layer(layer), 0.0f), casters.draw_first);
    draw("shadow_passed",
         {clear(now_->passed.layer(layer), glm::vec4(1.0f)), clear(now_->last_depth.layer(layer), glm::vec4(1.0f))},
         read_only(now_->map.layer(layer)), casters.draw_passed);
}
// [/draw_passed]

// [copy_views]
// A map that another view has, drawn from the same casters in the same way, is copied from there.
void Shadow::copy_views(Frame& frame, const std::vector<Wanted>& wanted) {
    std::vector<std::pair<ImageView, ImageView>> copies;
    const auto copy_layers = [&](const ViewMaps& other, uint32_t from, uint32_t into) {
        const auto add = [&](const Image& a, const Image& b) {
            copies.emplace_back(ImageView(a).layer(from), ImageView(b).layer(into));
        };
        add(other.map, now_->map);
        if (has_passed()) {
            add(other.first, now_->first), add(other.first_depth, now_->first_depth);
            add(other.passed, now_->passed), add(other.last_depth, now_->last_depth);
        }
        if (has_moments()) add(other.moments.moments, now_->moments.moments);
        now_->drawn[into] = other.drawn[from];
        ++copied_views;
    };
    for (const Wanted& w : wanted) {
        const uint32_t layer = w.view.data.layer;
        if (layer == NO_LAYER || now_->drawn[layer] == w.key) continue;
        for (const auto& [id, other] : by_view_) {
            if (&other == now_ || other.made != now_->made || other.map.desc.size != now_->map.desc.size) continue;
            const auto found = std::find(other.drawn.begin(), other.drawn.end(), w.key);
            if (found == other.drawn.end()) continue;
            copy_layers(other, static_cast<uint32_t>(found - other.drawn.begin()), layer);
            break;
        }
    }
    if (!copies.empty()) frame.copy_images("shadow_copies", copies);
}
// [/copy_views]

void Shadow::forget() {
    for (auto& [id, maps] : by_view_) maps.drawn.assign(maps.drawn.size(), {});
}

// What maps depend on beside the casters.
std::string Shadow::map_key() const {
    std::string key = transparent.text();
    if (!has_moments()) return key;
    for (const KnobBase* knob :
         std::initializer_list<const KnobBase*>{&method, &format, &blur, &blur_by, &exponent, &exponent_negative})
        key += knob->text() + " ";
    return key;
}

// [record]
void Shadow::record(Frame& frame, const Scene& scene, const std::vector<Light>& lights, const Reach& reach,
                    const View& view, const Casters& casters) {
    const auto has_cascades = [](const Light& light) { return light.shadow && light.kind == Light::Kind::directional; };
    now_ = &by_view_[std::any_of(lights.begin(), lights.end(), has_cascades) ? view.id : 0];
    if (std::exchange(toggles_, Exercises::version()) != Exercises::version()) forget();
    now_->eye = {view.eye, view.pixel_rad()};
    const std::vector<Wanted> wanted = find_views(scene, lights, reach, view.camera, casters);
    std::vector<ShadowView> data;
    views = drawn_views = copied_views = 0;
    for (const Wanted& w : wanted) data.push_back(w.view.data), views += w.view.data.layer != NO_LAYER;
    reserve(frame, static_cast<uint32_t>(views));
    frame.upload("shadow_lights", now_->lights, shadow_lights_);
    frame.upload("shadow_views", now_->views, data);
    if (std::exchange(now_->made, map_key()) != map_key()) now_->drawn.assign(now_->drawn.size(), {});
    if (keep) copy_views(frame, wanted);
    for (uint32_t i = 0; i < wanted.size(); ++i) {
        const Wanted& w = wanted[i];
        const uint32_t layer = w.view.data.layer;
        if (layer == NO_LAYER || (keep && now_->drawn[layer] == w.key)) continue;
        draw_view(frame, w, casters);
        if (has_passed()) draw_passed(frame, w, casters);
        if (has_moments())
            now_->moments.record(frame, now_->map.layer(layer), now_->views, i,
                                 blur_of(blur, exponent, exponent_negative), macros());
        now_->drawn[layer] = w.key;
        ++drawn_views;
    }
}
// [/record]

void Shadow::record(Frame& frame, const Scene& scene, const Lights& lights, const View& view, const Casters& casters) {
    const auto reach = [&](const Light& light) { return lights.reach_m(light); };
    record(frame, scene, lights.buffer().lights(), reach, view, casters);
}

void Shadow::record(Frame& frame, const Scene& scene, const std::vector<Light>& directional, const View& view,
                    const Casters& casters) {
    record(
        frame, scene, directional, [](const Light&) { return 0.0f; }, view, casters);
}

std::vector<Resource> Shadow::reads() const {
    std::vector<Resource> reads{now_->map, now_->lights, now_->views};
    if (has_moments()) reads.push_back(now_->moments.moments);
    if (has_passed()) reads.insert(reads.end(), {now_->first, now_->first_depth, now_->passed, now_->last_depth});
    return reads;
}

void Shadow::bind(Pass& pass) const {
    constexpr Sampler of_depth{.filter = Filter::nearest, .mip_filter = Filter::nearest, .wrap = Wrap::border};
    pass.offer("shadow_lights", now_->lights);
    pass.offer("shadow_views", now_->views);
    pass.offer("shadow_eye", now_->eye);
    pass.offer("shadow_map", now_->map.as_array(), of_depth);
    if (has_passed()) {
        pass.offer("shadow_first", now_->first.as_array(), linear_clamp);
        pass.offer("shadow_first_depth", now_->first_depth.as_array(), nearest_clamp);
        pass.offer("shadow_passed", now_->passed.as_array(), linear_clamp);
        pass.offer("shadow_last_depth", now_->last_depth.as_array(), nearest_clamp);
    }
    // A method without moments names them all the same, and reads none.
    pass.offer("shadow_moments", has_moments() ? now_->moments.moments.as_array() : now_->map.as_array(), linear_clamp);
}

std::vector<std::string> Shadow::status() const {
    if (views == 0) return {};
    return {fmt::format("{} shadow maps, {} drawn", views, drawn_views)};
}

}  // namespace lightwalk
