#include "05_shadow_maps/shadow.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "common/app/look.h"
#include "common/base/error.h"
#include "common/base/text.h"

namespace lightwalk {

Shadow::Shadow(Module& owner, std::string name) : Module(owner, std::move(name), "shadow") {}

void Shadow::prepare(Gpu&, Scene&) {
    layer_of_.clear();
    held_.clear();
    for (auto& [id, of_view] : by_view_) of_view.found_made.forget();
}

namespace {

// Said once where all objects of more than 8 pixels that the camera sees lie beyond the cascades, but for the ground.
void warn_of_end(const std::string& path, const Scene& scene, const View& view, float end_m) {
    float farthest_m = 0;
    const DrawList seen = scene.opaque().inside(view.view_projection);
    for (const uint32_t i : seen.items()) {
        const Bounds& box = scene.items[i].bounds;
        const float near_m = glm::length(glm::clamp(view.eye, box.lower, box.upper) - view.eye);
        const float size_m = glm::length(box.extent());
        if (near_m <= end_m && size_m < end_m) return;
        if (near_m > end_m && size_m > 8.0f * view.pixel_rad() * near_m)
            farthest_m = std::max(farthest_m, farthest_corner(box, view.eye));
    }
    if (farthest_m > 0)
        warn_once(
            fmt::format("{0}.distance_m: shadows end {1:g} m from the camera, before the objects that it sees; "
                        "set {0}.distance_m={2:.0f}",
                        path, end_m, std::ceil(farthest_m)));
}

}  // namespace

// The default distance includes what the camera looks at.
LightViewOptions Shadow::view_options(const Camera& camera) const {
    const float target_m = glm::length(camera.target - camera.position);
    const float reach_m = distance_m.changed() ? distance_m.value : std::max(distance_m.value, 1.25f * target_m);
    return {resolution, near_m, cascades, split, reach_m, snap};
}

// Views of all lights that cast shadows.
void Shadow::find_views(const Scene& scene, const std::vector<Light>& lights, const Reach& reach, const View& view,
                        const Casters& casters) {
    std::vector<MapView>& maps = now_->maps;
    maps.clear();
    now_->shadow_lights.clear();
    Bounds bounds = scene.bounds;
    bounds.add(casters.others);
    const LightViewOptions options = view_options(view.camera);
    const auto has_shadow = [this](const DrawItem&) { return has_passed(); };
    for (const Light& light : lights) {
        ShadowLight& shadow = now_->shadow_lights.emplace_back();
        shadow = {.position = light.position, .first_view = static_cast<uint32_t>(maps.size())};
        if (!light.shadow || method.is("none") || bounds.empty()) continue;
        const std::vector<LightView> seen = light_views(light, reach(light), bounds, view.camera, options);
        if (!distance_m.changed() && light.kind == Light::Kind::directional && !seen.back().whole)
            warn_of_end(path(), scene, view, options.distance_m);
        for (auto one = seen.begin(); one != seen.end(); ++one) {
            // Skips casters whose shadows only finer cascades show. The whole scene's map keeps all, since it does not
            // depend on the camera.
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

// Hash of everything that a map depends on.
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

void Shadow::take_layers(Frame& frame, const View& view) {
    const uint32_t most = frame.gpu.device.properties.limits.maxImageArrayLayers;
    if (layer_of_.size() + now_->maps.size() > most) {  // layers of removed lights included
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

// Images for all layers; recreated ones are empty.
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

void Shadow::draw_map(Frame& frame, const MapView& map, const Casters& casters) {
    const ViewScope scope(frame, map.view.view);
    frame.raster("shadow_map", {.depth = clear(depth_of(map), 0.0f), .with = casters.with}, [&](Raster& pass) {
        if (map.casters.size() > 0 && casters.draw)
            casters.draw(pass, map.casters);
        else if (map.casters.size() > 0)
            pass.use(solid).draw(map.casters);
        if (map.others) casters.draw_others(pass, map.view.view);
    });
}

// Transmittance of transparent casters: the first one's, and the product of all. Points between the first and the last
// use the first one's, which is exact for two.
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

// [record]
void Shadow::find_maps(Frame& frame, const Scene& scene, const LightList& lights, const Reach& reach, const View& view,
                       const Casters& casters) {
    const bool has_cascades = std::ranges::any_of(
        *lights, [](const Light& light) { return light.shadow && light.kind == Light::Kind::directional; });
    now_ = &by_view_[has_cascades ? view.id : 0];
    // The default bias is at most two texels, so that it is small where the whole scene is, and at least some steps of the
    // map's floats.
    now_->eye = bias_m.changed() ? ShadowEye{view.eye, view.pixel_rad(), 1e30f, 0.0f}
                                 : ShadowEye{view.eye, view.pixel_rad(), 2.0f, std::exp2(-19.0f)};

    // 1. The lights' views, if a light, the camera of cascades, a caster or a knob has changed.
    std::vector<float> reach_m;
    for (const Light& light : *lights) reach_m.push_back(light.shadow ? reach(light) : 0.0f);
    const bool same_lights = std::exchange(now_->found_for, lights) == lights;
    if (!now_->found_made.is_current(reach_m, has_cascades ? view.camera : Camera{}, scene.epoch, casters.others,
                                     casters.others_placed, epoch()) ||
        !same_lights) {
        find_views(scene, *lights, reach, view, casters);
    }

    // 2. A layer for each map, and its number for shaders. Maps that stay are listed with the frame's images.
    take_layers(frame, view);
    reserve(frame);
    for (const MapView& map : now_->maps)
        if (const uint32_t layer = map.view.data.layer; layer != NO_LAYER && keep && held_[layer] == map.shows)
            list_kept(frame, "shadow_map depth", depth_of(map));
    std::vector<ShadowView> data;
    for (const MapView& map : now_->maps) data.push_back(map.view.data);
    if (!now_->uploaded.is_current(now_->shadow_lights, data)) {
        frame.upload("shadow_lights", now_->lights, now_->shadow_lights);
        frame.upload("shadow_views", now_->views, data);
    }
}

Shadow::MapViews Shadow::maps_to_draw() {
    MapViews stale;
    for (const MapView& map : now_->maps) {
        const uint32_t layer = map.view.data.layer;
        if (layer == NO_LAYER || (keep && held_[layer] == map.shows)) continue;
        held_[layer] = map.shows;
        stale.emplace_back(map);
    }
    drawn_views = static_cast<int>(stale.size());
    return stale;
}

void Shadow::draw_maps(Frame& frame, const Casters& casters) {
    for (const MapView& map : maps_to_draw()) {
        draw_map(frame, map, casters);
        if (has_passed()) draw_passed(frame, map, casters);
        if (has_moments()) filter(frame, map);
    }
}
// [/record]

void Shadow::filter(Frame& frame, const MapView& map) {
    const auto number = static_cast<uint32_t>(&map - now_->maps.data());
    moments_.record(frame, depth_of(map), now_->views, number, blur_of(blur, exponent, exponent_negative), macros());
}

void Shadow::find_maps(Frame& frame, const Scene& scene, const Lights& lights, const View& view,
                       const Casters& casters) {
    const auto reach = [&](const Light& light) { return lights.reach_m(light); };
    find_maps(frame, scene, lights.buffer().list(), reach, view, casters);
}

void Shadow::record(Frame& frame, const Scene& scene, const Lights& lights, const View& view, const Casters& casters) {
    find_maps(frame, scene, lights, view, casters);
    draw_maps(frame, casters);
}

void Shadow::record(Frame& frame, const Scene& scene, const std::vector<Light>& directional, const View& view,
                    const Casters& casters) {
    if (!directional_ || *directional_ != directional)
        directional_ = std::make_shared<const std::vector<Light>>(directional);
    find_maps(
        frame, scene, directional_, [](const Light&) { return 0.0f; }, view, casters);
    draw_maps(frame, casters);
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
    // Placeholder for methods without moments, whose shaders declare the texture too.
    pass.set_if_present("shadow_moments", has_moments() ? moments_.moments.as_array() : map_.as_array(), linear_clamp);
}

std::vector<std::string> Shadow::status() const {
    if (views == 0) return {};
    return {fmt::format("{} shadow maps, {} drawn", views, drawn_views)};
}

Blur blur_of(int radius, float exponent, float exponent_negative) {
    Blur blur{.radius = radius, .exponent = exponent, .exponent_negative = exponent_negative};
    float sum = 0;
    for (int i = 0; i <= radius; ++i) {
        const float t = 2.5f * static_cast<float>(i) / (static_cast<float>(radius) + 0.5f);
        blur.weights[i] = std::exp(-0.5f * t * t);
        sum += (i > 0 ? 2.0f : 1.0f) * blur.weights[i];
    }
    blur.weights[0] = 1;
    for (int i = 1; i <= radius; ++i) {
        blur.weights[i] /= sum;
        blur.weights[0] -=
            2.0f * blur.weights[i];  // remainder, so that weights sum to exactly 1: moments amplify any error
    }
    return blur;
}

bool MomentMaps::ensure(Gpu& gpu, const Image& map, VkFormat format) {
    const Image::Desc wanted{.name = map.desc.name + " moments",
                             .format = format,
                             .size = map.desc.size,
                             .mips = full_mip_count(map.desc.size),
                             .layers = map.desc.layers,
                             .kept = true};
    if (!moments.ensure(gpu.device, wanted)) return false;
    between_ = Image(gpu.device, {.name = wanted.name + " between", .format = format, .size = wanted.size});
    return true;
}

// Blur along u, then along v, then mips; each step waits for the previous one.
void MomentMaps::record(Frame& frame, const ImageView& layer, const Buffer& views, uint32_t view, Blur blur,
                        const Macros& macros) {
    const ImageView into = ImageView(moments).layer(layer.first_layer);
    blur.view = view;
    const uint32_t size = moments.desc.size.x;
    const glm::uvec3 groups((size + 63) / 64, (size + 3) / 4, 1);
    frame.compute("blur", {.reads = {layer, views, between_}, .writes = {between_, into.mip(0)}}, [&](Compute& pass) {
        pass.use(first_, macros).set("blur", blur).set("shadow_views", views);
        pass.set("source", layer, nearest_clamp).set("result", between_).dispatch(groups).wait();
        pass.use(second_, macros)
            .set("blur", blur)
            .set("shadow_views", views)
            .set("source", between_, nearest_clamp)
            .set("result", into.mip(0))
            .dispatch(groups);
    });
    frame.compute("moment_mips", {.reads = {into}, .writes = {into}}, [&](Compute& pass) {
        for (uint32_t mip = 1; mip < moments.desc.mips; ++mip) {
            pass.use(halve_).set("source", into.mip(mip - 1), nearest_clamp).set("result", into.mip(mip));
            pass.dispatch_threads(glm::uvec2(std::max(size >> mip, 1u))).wait();
        }
    });
}

}  // namespace lightwalk
