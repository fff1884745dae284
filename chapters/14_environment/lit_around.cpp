#include "14_environment/lit_around.h"

namespace lightwalk {

ScreenOcclusion::ScreenOcclusion(Module& owner, std::string name)
    : Module(owner, std::move(name), "screen_occlusion") {}

LitAround::LitAround(Module& owner, std::string name, const ImageLight& light)
    : Drawing(owner, name),
      lit(owner, name, Shading{.seen = &seen_}),
      screen_occlusion(owner, "screen_occlusion"),
      substances(owner, "substance"),
      paint(owner, "paint"),
      rays(owner, "rays") {
    shading = {.opaque = &surface_, .seen = &seen_, .transparent = &glass_, .with = {light, substances, paint}};
}

std::vector<const Module*> LitAround::dependencies() const {
    std::vector<const Module*> all = lit.dependencies();
    all.push_back(this);
    return all;
}

void LitAround::update(Frame& frame) {
    lit.update_once(frame);
    paint.record(frame);
    const bool by_rays = occlusion.is("rays"), on_screen = occlusion.is("screen_space");
    shading.opaque = by_rays ? &occluded_ : on_screen ? &screen_occluded_ : &surface_;
    shading.seen = by_rays ? &occluded_seen_ : on_screen ? nullptr : &seen_;
    std::erase_if(shading.with,
                  [this](const With& one) { return &one.get() == &rays || &one.get() == &screen_occlusion; });
    if (on_screen) shading.with.emplace_back(screen_occlusion);
    if (!by_rays) return;
    rays.record(frame, surfaces.scene(), &maps);
    shading.with.emplace_back(rays);
}

// Depth first, where occlusion is sought in it.
void LitAround::draw(Frame& frame, const View& view, Canvas& canvas) {
    if (occlusion.is("screen_space")) {
        frame.raster("depth", {.depth = canvas.single_depth_target(), .with = {maps}},
                     surfaces.by(surfaces.depth_pipelines()));
        screen_occlusion.record(frame, view, canvas.single_depth());
    }
    lit.draw(frame, view, canvas);
}

namespace {

// As 14_environment/occlusion_step.glsl has it.
struct Step {
    ViewRays rays;
    glm::vec2 shrink;      ///< pixels of the depth for one in which horizons are sought
    float pixels_per_rad;  ///< in the middle of the picture
    float radius_m, thickness;
    int32_t slices, steps;
};

}  // namespace

void ScreenOcclusion::record(Frame& frame, const View& view, const ImageView& depth) {
    const glm::uvec2 size(depth.size()), small = resolution.is("half") ? (size + 1u) / 2u : size;
    const auto fit = [&](Image& image, const char* name, glm::uvec2 side) {
        image.ensure(frame.gpu.device, {.name = path() + name, .size = side});
    };
    fit(found_, " found", small);
    fit(wide_, " image", size);
    const Step step{.rays = view_rays(view),
                    .shrink = glm::vec2(resolution.is("half") ? 2.0f : 1.0f),
                    .pixels_per_rad = 1.0f / view.pixel_rad(),
                    .radius_m = radius_m,
                    .thickness = thickness,
                    .slices = slices,
                    .steps = steps};
    frame.compute("horizons", {.reads = {depth}, .writes = {found_}}, [&](Compute& pass) {
        pass.use(seek_).set("depth", depth, nearest_clamp).set("occlusion_step", step);
        pass.set("found", found_).dispatch_threads(small);
    });
    frame.compute("widen occlusion", {.reads = {depth, found_}, .writes = {wide_}}, [&](Compute& pass) {
        pass.use(widen_).set("depth", depth, nearest_clamp).set("occlusion_step", step);
        pass.set("found", found_, nearest_clamp).set("wide", wide_).dispatch_threads(size);
    });
}

std::vector<Resource> ScreenOcclusion::reads() const {
    return wide_ ? std::vector<Resource>{wide_} : std::vector<Resource>{};
}

void ScreenOcclusion::bind(Pass& pass) const {
    if (wide_) pass.set_if_present("screen_occlusion_image", wide_, nearest_clamp);
}

}  // namespace lightwalk
