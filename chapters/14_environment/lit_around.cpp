#include "14_environment/lit_around.h"

namespace lightwalk {

LitAround::LitAround(Module& owner, std::string name, const ImageLight& light)
    : Drawing(owner, name),
      lit(owner, name, Shading{}),
      substances(owner, "substance"),
      paint(owner, "paint"),
      rays(owner, "rays") {
    shading = {.opaque = &surface_, .transparent = &glass_, .with = {light, substances, paint}};
}

std::vector<const Module*> LitAround::made_of() const {
    std::vector<const Module*> all = lit.made_of();
    all.push_back(this);
    return all;
}

void LitAround::update(Frame& frame) {
    lit.update_once(frame);
    paint.record(frame);
    const bool occluded = !occlusion.is("none");
    shading.opaque = occluded ? &occluded_ : &surface_;
    std::erase_if(shading.with, [this](const With& one) { return &one.get() == &rays; });
    if (!occluded) return;
    rays.record(frame, surfaces.scene(), &maps);
    shading.with.emplace_back(rays);
}

}  // namespace lightwalk
