#include "14_environment/lit_around.h"

namespace lightwalk {

LitAround::LitAround(Module& owner, std::string name, const ImageLight& light)
    : LitScene(owner, std::move(name)), substances(owner, "substance"), paint(owner, "paint"), light_(light) {
    shading = &surface_;
    transparent_shading = &glass_;
}

std::vector<With> LitAround::given() const {
    std::vector<With> with = LitScene::given();
    with.insert(with.end(), {light_, substances, paint});
    return with;
}

}  // namespace lightwalk
