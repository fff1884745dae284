// A scene's objects in the light of their surroundings, as a drawing.
#pragma once
#include "05_shadow_maps/lit_scene.h"
#include "14_environment/image_light.h"
#include "14_environment/paint.h"
#include "14_environment/substances.h"

namespace lightwalk {

// [lit_around]
/// LitScene, whose ambient light is an ImageLight: the owner records that before it draws.
struct LitAround : LitScene {
    LitAround(Module& owner, std::string name, const ImageLight& light);

    Substances substances;
    Paint paint;

    void update(Frame& frame) override {
        LitScene::update(frame);
        paint.record(frame);
    }
    // [/lit_around]

  protected:
    std::vector<With> given() const override;

  private:
    const ImageLight& light_;
    SurfacePipelines surface_{{.fragment = "14_environment/surface.frag"}};
    SurfacePipelines glass_ =
        see_through("14_environment/surface.frag", {{"LIGHTS_METHOD", "LIGHTS_METHOD_EVERY_LIGHT"}});
};

}  // namespace lightwalk
