#include "05_shadow_maps/shadow.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "common/base/error.h"

namespace lightwalk {

Shadow::Shadow(Module& owner, std::string name) : Module(owner, std::move(name), "shadow") {}

void Shadow::prepare(Gpu&, Scene&) {
    layer_of_.clear();
    held_.clear();
    for (auto& [id, of_view] : by_view_) of_view.found_made.forget();
}

// [find_views]
// The views of all lights that cast shadows.
void Shadow::find_views(const Scene& scene, const std::vector<Light>& lights, const Reach& reach, const View& view,
                        const Casters& casters) {
    std::vector<MapView>& maps = now_->maps;
    maps.clear();
    now_->shadow_lights.clear();
    Bounds bounds = scene.bounds;
    bounds.add(casters.others);
    const auto has_shadow = [this](const DrawItem&) { return has_passed(); };
    for (const Light& light : lights) {
        ShadowLight& shadow = now_->shadow_lights.emplace_back();
        shadow = {.position = light.position, .first_view = static_cast<uint32_t>(maps.size())};
        if (!light.shadow || method.is("none") || bounds.empty()) continue;
        const std::vector<LightView> seen = light_views(light, reach(light), bounds, view.camera, view_options());
        for (auto one = seen.begin(); one != seen.end(); ++one) {
            // Skips casters needed only by finer cascades; but the whole scene's map is the same from every
            // viewpoint.
            const auto is_needed = [&](const DrawItem& item) {
                return one->whole || std::none_of(seen.begin(), one, [&](const LightView& finer) {
                           return holds_shadow_of(finer, item.bounds, one->data.texel);
                       });
            };
            const auto inside = [&](const DrawList& list) { return list.inside(one->casters).where(is_needed); };
            MapView& map =
                maps.emplace_back(MapView{*one, inside(scene.opaque()), inside(scene.transparent()).where(has_shadow)});
            map.others = !casters.others.empty() && may_show(casters.others, one->casters);
            map.shows = hash_of(map, scene, casters);
        }
        const auto first = maps.begin() + shadow.first_view;
        if (std::none_of(first, maps.end(), [](const MapView& map) { return map.is_needed(); }))
            maps.erase(first, maps.end());
        shadow.views = static_cast<uint32_t>(maps.size()) - shadow.first_view;
        const bool parallel = light.kind == Light::Kind::directional;
        shadow.kind = parallel ? LIGHT_DIRECTIONAL : shadow.views == 6 ? LIGHT_POINT : LIGHT_SPOT;
        shadow.size = parallel ? 2.0f * std::tan(0.5f * light.size_rad) : light.size_m;
    }
}

// A hash of all that a map depends on: two maps with the same hash show the same.
uint64_t Shadow::hash_of(const MapView& map, const Scene& scene, const Casters& casters) const {
    Hash hash;
    bool deforms = false;
    for (const DrawList* const list : {&map.casters, &map.passed})
        for (const uint32_t i : list->items()) {
            const DrawItem& item = scene.items[i];
            hash.add(lightwalk::hash_of(item.model.get(), item.mesh, item.part, item.transform));
            deforms |= static_cast<bool>(item.model->model.meshes[item.mesh].deformation);
        }
    return lightwalk::hash_of(hash.value, map.view.view.view_projection, casters.others_placed, epoch(),
                              deforms || map.passed.size() > 0 ? scene.epoch : 0);
}
// [/find_views]

// [layers]
void Shadow::take_layers(Frame& frame, const View& view) {
    const uint32_t most = frame.gpu.device.properties.limits.maxImageArrayLayers;
    if (layer_of_.size() + now_->maps.size() > most) {  // of lights that have gone, too
        layer_of_.clear();
        held_.clear();
    }
    views = static_cast<int>(std::ranges::count_if(now_->maps, &MapView::is_needed));
    if (views > static_cast<int>(most))
        throw InputError("the lights need {} shadow maps; this device has at most {}", views, most);
    for (uint32_t light = 0; light < now_->shadow_lights.size(); ++light)
        for (uint32_t i = 0; i < now_->shadow_lights[light].views; ++i) {
            MapView& map = now_->maps[now_->shadow_lights[light].first_view + i];
            map.view.data.layer = NO_LAYER;
            if (!map.is_needed()) continue;
            const bool is_cascade = now_->shadow_lights[light].kind == LIGHT_DIRECTIONAL && !map.view.whole;
            const auto [place, added] = layer_of_.try_emplace(
                {is_cascade ? view.id : 0, light, map.view.whole ? ~0u : i}, static_cast<uint32_t>(held_.size()));
            if (added) held_.push_back(0);
            map.view.data.layer = place->second;
        }
}

// Images for all layers. New ones, of another size or with more layers, hold nothing yet.
void Shadow::reserve(Frame& frame) {
    const auto size = glm::uvec2(static_cast<uint32_t>(resolution.value));
    const uint32_t there = map_.desc.size == size ? map_.desc.layers : 1;
    const Image::Desc wanted{
        .size = size, .layers = std::max(static_cast<uint32_t>(held_.size()), there), .kept = true};
    bool is_new = false;
    const auto fit = [&](Image& image, const char* name, VkFormat of) {
        Image::Desc desc = wanted;
        desc.name = path() + name;
        desc.format = of;
        is_new |= image.ensure(frame.gpu.device, desc);
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
        is_new |= moments_.ensure(frame.gpu, map_,
                                  format.is("fp16") ? VK_FORMAT_R16G16B16A16_SFLOAT : VK_FORMAT_R32G32B32A32_SFLOAT);
    if (is_new) held_.assign(held_.size(), 0);
}
// [/layers]

// [draw_map]
void Shadow::draw_map(Frame& frame, const MapView& map, const Casters& casters) {
    const ViewScope scope(frame, map.view.view);
    frame.raster("shadow_map", {.depth = clear(map_.layer(map.view.data.layer), 0.0f), .with = casters.with},
                 [&](Raster& pass) {
                     if (map.casters.size() > 0 && casters.draw)
                         casters.draw(pass, map.casters);
                     else if (map.casters.size() > 0)
                         pass.use(solid).draw(map.casters);
                     if (map.others) casters.draw_others(pass, map.view.view);
                 });
}
// [/draw_map]

// [draw_passed]
// Transmittance of transparent casters: the first one's, and the product of all. A point between the first and the
// last uses the first for all before it, which is right for two.
void Shadow::draw_passed(Frame& frame, const MapView& map, const Casters& casters) {
    const ViewScope scope(frame, map.view.view);
    const uint32_t layer = map.view.data.layer;
    const auto draw = [&](const char* name, std::vector<Attachment> color, Attachment depth, const Casters::Draw& by) {
        frame.raster(name, {.color = std::move(color), .depth = depth, .with = casters.with}, [&](Raster& pass) {
            if (by && map.passed.size() > 0) by(pass, map.passed);
        });
    };
    draw("shadow_first", {clear(first_.layer(layer), glm::vec4(1.0f))}, clear(first_depth_.layer(layer), 0.0f),
         casters.draw_first);
    draw("shadow_passed",
         {clear(passed_.layer(layer), glm::vec4(1.0f)), clear(last_depth_.layer(layer), glm::vec4(1.0f))},
         read_only(map_.layer(layer)), casters.draw_passed);
}
// [/draw_passed]

// [record]
void Shadow::record(Frame& frame, const Scene& scene, const LightList& lights, const Reach& reach, const View& view,
                    const Casters& casters) {
    const bool has_cascades = std::ranges::any_of(
        *lights, [](const Light& light) { return light.shadow && light.kind == Light::Kind::directional; });
    now_ = &by_view_[has_cascades ? view.id : 0];
    now_->eye = {view.eye, view.pixel_rad()};

    // 1. The lights' views, if a light, the camera of cascades, a caster or a knob has changed.
    std::vector<float> reach_m;
    for (const Light& light : *lights) reach_m.push_back(light.shadow ? reach(light) : 0.0f);
    const bool same_lights = std::exchange(now_->found_for, lights) == lights;
    if (!now_->found_made.is_current(reach_m, has_cascades ? view.camera : Camera{}, scene.epoch, casters.others,
                                     casters.others_placed, epoch()) ||
        !same_lights) {
        find_views(scene, *lights, reach, view, casters);
    }

    // 2. A layer for each map, and its number for shaders.
    take_layers(frame, view);
    reserve(frame);
    std::vector<ShadowView> data;
    for (const MapView& map : now_->maps) data.push_back(map.view.data);
    if (!now_->uploaded.is_current(now_->shadow_lights, data)) {
        frame.upload("shadow_lights", now_->lights, now_->shadow_lights);
        frame.upload("shadow_views", now_->views, data);
    }

    // 3. Maps that show something else than their layers hold.
    drawn_views = 0;
    for (uint32_t i = 0; i < now_->maps.size(); ++i) {
        const MapView& map = now_->maps[i];
        const uint32_t layer = map.view.data.layer;
        if (layer == NO_LAYER || (keep && held_[layer] == map.shows)) continue;
        draw_map(frame, map, casters);
        if (has_passed()) draw_passed(frame, map, casters);
        if (has_moments())
            moments_.record(frame, map_.layer(layer), now_->views, i, blur_of(blur, exponent, exponent_negative),
                            macros());
        held_[layer] = map.shows;
        ++drawn_views;
    }
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
    std::vector<Resource> reads{map_, now_->lights, now_->views};
    if (has_moments()) reads.push_back(moments_.moments);
    if (has_passed()) reads.insert(reads.end(), {first_, first_depth_, passed_, last_depth_});
    return reads;
}

void Shadow::bind(Pass& pass) const {
    constexpr Sampler of_depth{.filter = Filter::nearest, .mip_filter = Filter::nearest, .wrap = Wrap::border};
    pass.set_if_present("shadow_lights", now_->lights);
    pass.set_if_present("shadow_views", now_->views);
    pass.set_if_present("shadow_eye", now_->eye);
    pass.set_if_present("shadow_map", map_.as_array(), of_depth);
    if (has_passed()) {
        pass.set_if_present("shadow_first", first_.as_array(), linear_clamp);
        pass.set_if_present("shadow_first_depth", first_depth_.as_array(), nearest_clamp);
        pass.set_if_present("shadow_passed", passed_.as_array(), linear_clamp);
        pass.set_if_present("shadow_last_depth", last_depth_.as_array(), nearest_clamp);
    }
    // A method without moments names them all the same, and reads none.
    pass.set_if_present("shadow_moments", has_moments() ? moments_.moments.as_array() : map_.as_array(), linear_clamp);
}

std::vector<std::string> Shadow::status() const {
    if (views == 0) return {};
    return {fmt::format("{} shadow maps, {} drawn", views, drawn_views)};
}

}  // namespace lightwalk
