#include "14_environment/lit_around.h"

namespace lightwalk {

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

// [screen_space]
// Depth first, where occlusion is sought in it.
void LitAround::draw(Frame& frame, const View& view, Canvas& canvas) {
    if (occlusion.is("screen_space")) {
        frame.raster("depth", {.depth = canvas.single_depth_target(), .with = {maps}},
                     surfaces.by(surfaces.depth_pipelines()));
        screen_occlusion.record(frame, view, canvas.single_depth());
    }
    lit.draw(frame, view, canvas);
}
// [/screen_space]

}  // namespace lightwalk
