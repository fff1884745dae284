#include "12_skin/skin.h"

#include <fmt/core.h>

#include <bit>
#include <cmath>
#include <utility>

#include "12_skin/sums.h"
#include "common/base/error.h"

namespace lightwalk {

namespace {

constexpr VkFormat half4 = VK_FORMAT_R16G16B16A16_SFLOAT;

void make(Frame& frame, Image& image, const char* name, uint32_t size, VkFormat format = half4) {
    image.ensure(frame.gpu.device, {.name = name, .format = format, .size = glm::uvec2(size), .kept = true});
}

}  // namespace

Skin::Skin(Module& owner, std::string name) : Module(owner, std::move(name), "skin") {}

const DrawItem* Skin::part(const Scene& scene, Role role, bool any) {
    for (const DrawItem& item : scene.items)
        if (item.role == role) return &item;
    return any && !scene.items.empty() ? &scene.items.front() : nullptr;
}

int Skin::sum_count() const {
    const std::string name = method.text(), prefix = "gaussians_";
    return name.starts_with(prefix) ? std::stoi(name.substr(prefix.size())) : 0;
}

const Image* Skin::map(std::string_view name, size_t of_level) const {
    if (empty_) return nullptr;
    if (name == "stretch") return &layout().stretch;
    if (name == "occlusion") return &occlusion();
    if (on_map() && name == "irradiance") return &irradiance();
    if (on_map() && name == "diffused") return &diffused();
    return sum_count() && name == "level" ? &level(of_level) : nullptr;
}

std::vector<std::string> Skin::status() const {
    if (!on_map() || empty_) return {};
    return {fmt::format("the map of light is {} texels wide", irradiance_.desc.size.x)};
}

void Skin::prepare(Gpu& gpu, Scene& scene) {
    add_charts(gpu, scene);
    for (Unwrapped* unwrapped : {&coarse_, &fine_, &eye_}) unwrapped->forget();
    scale_made_.forget();
}

// How wide a pixel is there, in mm.
static double pixel_mm(double away_m, const Camera& camera, uint32_t screen_height) {
    return std::max(2000 * away_m * std::tan(0.5 * double(camera.fov_y_rad)) / screen_height, 1e-6);
}

double Skin::widest_px(float away_m, const Camera& camera, uint32_t screen_height) {
    return std::sqrt(double(skin_variance_mm2[SKIN_GAUSSIANS - 1])) / pixel_mm(double(away_m), camera, screen_height);
}

// Measured once for each placement: all triangles take most of a frame's recording.
double Skin::scale_of(const DrawItem& item) const {
    if (scale_made_.is_current(item.model.get(), item.mesh, item.part, item.transform)) return mm_per_uv_;
    ++measured;
    return mm_per_uv_ = mm_per_uv(item);
}

uint32_t Skin::size_for(const DrawItem& item, const Camera& camera, uint32_t screen_height) const {
    if (map_size > 0) return static_cast<uint32_t>(map_size);
    const double away_m = double(glm::length(item.bounds.center() - camera.position));
    const double texels = double(density) * scale_of(item) / pixel_mm(away_m, camera, screen_height);
    return 1u << std::clamp(static_cast<int>(std::lround(std::log2(std::max(texels, 1.0)))), 6, 11);
}

void Skin::make_tables(Frame& frame) {
    if (tables_made_.is_current(f0.value, Exercises::epoch())) return;
    make(frame, facets_, "skin facets", 256, VK_FORMAT_R8G8B8A8_UNORM);
    make(frame, reflected_, "skin reflected", 32);
    make(frame, preintegrated_, "skin preintegrated", 64);
    frame.compute("skin tables", {.writes = {facets_, reflected_, preintegrated_}}, [&](Compute& pass) {
        pass.use(facets_table_, {{"SKIN_SPECULAR", "0"}, {"SKIN_SPECULAR_TABLES", "1"}}).set("result", facets_);
        pass.dispatch_threads(facets_.desc.size);
        pass.use(reflected_table_).set("result", reflected_).set("f0", f0.value).dispatch_threads(reflected_.desc.size);
        pass.use(preintegrated_table_).set("result", preintegrated_).dispatch_threads(preintegrated_.desc.size);
    });
}

void Skin::record(Frame& frame, const Scene& scene, const View& view, const Lit& lit) {
    const DrawItem *skin = skin_of(scene), *eye = part(scene, Role::eye);
    spread_out_ = false;
    if (empty_ = !skin; empty_) return;
    make_tables(frame);

    // 1. Sky light, once: from a small map, and rays from each of its texels.
    const bool other_rays = std::exchange(sky_rays_, sky_rays.value) != sky_rays.value;
    if (coarse_.record(frame, scene, lit.maps, *skin, static_cast<uint32_t>(sky_size)) || other_rays)
        coarse_.trace_sky(frame, lit.rays, static_cast<uint32_t>(sky_rays));
    if (eye && (eye_.record(frame, scene, lit.maps, *eye, static_cast<uint32_t>(sky_size) / 2) || other_rays))
        eye_.trace_sky(frame, lit.rays, static_cast<uint32_t>(sky_rays));
    if (!on_map()) return;

    // 2. The surface laid out as large as the screen needs; the light that enters it; how that spreads.
    fine_.record(frame, scene, lit.maps, *skin, size_for(*skin, view.camera, view.crop.whole.y));
    light_map(frame, lit);
    spread_.record(frame, {irradiance_, fine_.stretch, fine_.position}, sum_count());
    spread_out_ = true;
}

void Skin::light_map(Frame& frame, const Lit& lit) {
    const uint32_t size = fine_.position.desc.size.x;
    make(frame, irradiance_, "skin irradiance", size);
    std::vector<With> with = lit.with;
    with.push_back(*this);
    frame.compute(
        "skin irradiance",
        {.reads = {fine_.position, fine_.normal, fine_.albedo}, .writes = {irradiance_}, .with = with},
        [&](Compute& pass) {
            pass.use(irradiance_pass_).set("skin_position", fine_.position, nearest_clamp);
            pass.set("skin_normal", fine_.normal, nearest_clamp).set("skin_albedo", fine_.albedo, nearest_clamp);
            pass.set("result", irradiance_).dispatch_threads(irradiance_.desc.size);
        });
}

// Which triangle each pixel shows, then a dispatch for each of skin, eyes and cloth.
void Skin::draw_visible(Frame& frame, const Scene& scene, Canvas& canvas, const Lit& lit,
                        const std::vector<With>& with) {
    const DrawItem* skin = skin_of(scene);
    std::vector<Batch> of_skin, of_eyes, others, all;
    for (const Batch& batch : scene.all().batches()) {
        const DrawItem& item = batch.item();
        if (item.role == Role::cornea) continue;
        all.push_back(batch);
        (&item == skin ? of_skin : item.role == Role::eye ? of_eyes : others).push_back(batch);
    }
    const Pipeline& look = on_map()                     ? seen_map_
                           : method.is("wrapped")       ? seen_wrap_
                           : method.is("preintegrated") ? seen_table_
                                                        : seen_lambert_;
    visibility_.record(frame, scene, lit.maps, all, canvas);
    visibility_.shade(frame, scene, lit.maps, others, canvas, matt_seen_, with);
    visibility_.shade(frame, scene, lit.maps, of_eyes, canvas, eye_seen_, with);
    visibility_.shade(frame, scene, lit.maps, of_skin, canvas, look, with);
}

void Skin::draw(Frame& frame, const Scene& scene, Canvas& canvas, const Lit& lit, Shown shown) {
    if (empty_) return;
    const bool on_screen = method.is("separable") && shown == Shown::all;
    shown_ = static_cast<int>(shown) - 1;
    const Pipeline& look = shown != Shown::all          ? views_
                           : on_map()                   ? by_map_
                           : on_screen                  ? by_screen_
                           : method.is("wrapped")       ? by_wrap_
                           : method.is("preintegrated") ? by_table_
                                                        : by_lambert_;
    std::vector<With> with = lit.with;
    with.insert(with.end(), {*this, lit.maps});
    const DrawItem* skin = skin_of(scene);
    const auto is_skin = [&](const DrawItem& item) { return &item == skin; };
    const auto is_eye = [&](const DrawItem& item) { return item.role == Role::eye; };
    const auto is_cornea = [&](const DrawItem& item) { return item.role == Role::cornea; };
    const auto is_other = [&](const DrawItem& item) { return !is_skin(item) && !is_eye(item) && !is_cornea(item); };
    const auto draw = [&](Raster& pass, const auto& predicate, const Pipeline& pipeline) {
        lit.maps.draw(pass, scene, scene.all().where(predicate), pipeline, pipeline);
    };
    const auto draw_fragments = [&] {
        frame.raster("matt", {.color = {canvas.color_target()}, .depth = canvas.depth_target(), .with = with},
                     [&](Raster& pass) {
                         draw(pass, is_other, matt_);
                         draw(pass, is_eye, eye_pass_);
                     });
        RasterTargets targets{.color = {canvas.color_target()}, .depth = canvas.depth_target(), .with = with};
        if (on_screen) {
            screen_.ensure(frame.gpu.device, canvas.size());
            targets.color.push_back(clear(screen_.light, glm::vec4(0)));
            targets.color.push_back(clear(screen_.after, glm::vec4(0)));
        }
        frame.raster("skin", targets, [&](Raster& pass) { draw(pass, is_skin, look); });
    };
    const bool in_compute =
        shaded.is("visibility") && shown == Shown::all && !on_screen && VisibilityBuffer::suits(lit.maps, canvas);
    if (in_compute)
        draw_visible(frame, scene, canvas, lit, with);
    else
        draw_fragments();
    if (!part(scene, Role::cornea)) return;
    with.push_back(lit.rays);
    frame.raster("cornea", {.color = {canvas.color_target()}, .depth = canvas.depth_target(), .with = with},
                 [&](Raster& pass) { draw(pass, is_cornea, cornea_); });
}

void Skin::finish(Frame& frame, const View& view, Canvas& canvas) {
    if (method.is("separable") && !empty_) screen_.record(frame, view, canvas);
}

std::vector<Resource> Skin::reads() const {
    std::vector<Resource> all{facets_,           reflected_,      preintegrated_,
                              coarse_.occlusion, coarse_.stretch, coarse_.position};
    if (eye_.occlusion) all.push_back(eye_.occlusion);
    if (spread_out_) all.push_back(diffused());
    return all;
}

void Skin::bind(Pass& pass) const {
    pass.set_if_present("shown", shown_);
    pass.set_if_present("skin_facets", facets_, linear_clamp);
    pass.set_if_present("skin_reflected", reflected_, linear_clamp);
    pass.set_if_present("skin_preintegrated", preintegrated_, linear_clamp);
    pass.set_if_present("skin_occlusion", coarse_.occlusion, linear_clamp);
    pass.set_if_present("eye_occlusion", eye_.occlusion ? eye_.occlusion : coarse_.occlusion, linear_clamp);
    pass.set_if_present("skin_stretch", coarse_.stretch, linear_clamp);
    pass.set_if_present("skin_position", coarse_.position, nearest_clamp);
    pass.set_if_present("skin_diffused", spread_out_ ? diffused() : coarse_.occlusion, linear_clamp);
}

void PictureBlur::ensure(Device& device, glm::uvec2 size) {
    for (const auto& [image, name] : {std::pair{&light, "skin light"}, {&after, "skin after"}, {&half_, "skin half"}})
        image->ensure(device, {.name = name, .size = size});
}

void PictureBlur::record(Frame& frame, const View& view, Canvas& canvas) {
    constexpr int side = 8;
    if (!kernel_) kernel_ = frame.gpu.upload("skin line", line_kernel(side));
    ScreenBlur blur{
        .direction = {1, 0}, .taps = 2 * side + 1, .pixels_at_1m = 1.0f / view.pixel_rad(), .edge_mm = 5.0f};
    const ImageView hdr = canvas.color(frame);
    frame.compute("skin separable", {.reads = {light, half_, after, hdr}, .writes = {light, half_, hdr}},
                  [&](Compute& pass) {
                      pass.use(line_).set("from", light, linear_clamp).set("into", half_).set("blur", blur);
                      pass.set("kernel", kernel_).dispatch_threads(view.size).wait();
                      blur.direction = {0, 1};
                      pass.use(line_).set("from", half_, linear_clamp).set("into", light).set("blur", blur);
                      pass.set("kernel", kernel_).dispatch_threads(view.size).wait();
                      pass.use(add_).set("light", light, nearest_clamp).set("after", after, nearest_clamp);
                      pass.set("hdr", hdr).dispatch_threads(view.size);
                  });
}

namespace {

void make(Frame& frame, Image& image, const char* name, glm::uvec2 size, VkFormat format) {
    const Image::Desc desc{.name = name, .format = format, .size = size};
    image.ensure(frame.gpu.device, desc);
}

}  // namespace

void Spread::record(Frame& frame, const Maps& maps, int gaussians) {
    exactly_ = gaussians == 0;
    if (exactly_) return record_exactly(frame, maps);
    constexpr VkFormat half4 = VK_FORMAT_R16G16B16A16_SFLOAT;
    const glm::uvec2 size = maps.irradiance.desc.size;
    const std::vector<Gaussian> sum = gaussians_of(gaussians);
    make(frame, between_, "skin between", size, half4);
    make(frame, sum_, "skin sum", size, half4);
    levels_.resize(sum.size());
    std::vector<const Image*> levels;
    for (Image& level : levels_) {
        make(frame, level, "skin level", size, half4);
        levels.push_back(&level);
    }

    // 1. Each Gaussian from the one before it. Levels that an answer leaves out are black.
    if (!Exercises::uses_solution("12.blur_irradiance"))
        for (const Image& level : levels_) frame.fill("skin no level", level, glm::vec4(0));
    blur_irradiance(frame, {.line = sum.size() == 1 ? line_per_channel_ : line_,
                            .irradiance = maps.irradiance,
                            .stretch = maps.stretch,
                            .between = between_,
                            .levels = levels,
                            .sum = sum});

    // 2. Their sum, for each channel with its own weights.
    SkinSum parts{.weight = {}, .count = static_cast<uint32_t>(sum.size())};
    for (size_t i = 0; i < sum.size(); ++i) parts.weight[i] = sum[i].weight;
    ComputeAccess access{.reads = {}, .writes = {sum_}};
    for (const Image& level : levels_) access.reads.push_back(level);
    frame.compute("skin sum", access, [&](Compute& pass) {
        const std::vector<ImageView> views(levels_.begin(), levels_.end());
        pass.use(add_up_).set("levels", views, nearest_clamp).set("sum_of", parts).set("result", sum_);
        pass.dispatch_threads(size);
    });
}

void Spread::record_exactly(Frame& frame, const Maps& maps) {
    make(frame, exact_, "skin exact", maps.irradiance.desc.size, VK_FORMAT_R32G32B32A32_SFLOAT);
    frame.compute("skin exact", {.reads = {maps.irradiance, maps.stretch, maps.position}, .writes = {exact_}},
                  [&](Compute& pass) {
                      pass.use(every_texel_).set("from", maps.irradiance, nearest_clamp).set("result", exact_);
                      pass.set("stretch", maps.stretch, nearest_clamp);
                      pass.set("skin_position", maps.position, nearest_clamp).dispatch_threads(exact_.desc.size);
                  });
}

}  // namespace lightwalk
