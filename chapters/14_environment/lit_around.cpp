#include "14_environment/lit_around.h"

namespace lightwalk {

LitAround::LitAround(Module& owner, std::string name, const ImageLight& light)
    : LitScene(owner, std::move(name)),
      substances(owner, "substance"),
      paint(owner, "paint"),
      rays(owner, "rays"),
      light_(light) {
    transparent_shading = &glass_;
    shaded.reset();  // by fragment shaders alone
}

void LitAround::update(Frame& frame) {
    LitScene::update(frame);
    paint.record(frame);
    shading = occlusion.is("none") ? &surface_ : &occluded_;
    if (!occlusion.is("none")) rays.record(frame, *scene_, &maps);
}

std::vector<With> LitAround::given() const {
    std::vector<With> with = LitScene::given();
    with.insert(with.end(), {light_, substances, paint});
    if (!occlusion.is("none")) with.push_back(rays);
    return with;
}

}  // namespace lightwalk
